#include "phase_line.h"

#include <cstdio>
#include <numeric>
#include <string>

#include "comm.h"

using namespace LAMMPS_NS;

void PhaseLine::print(const std::vector<swellflow::PhaseTime> &times)
{
  seconds_before_.resize(times.size(), 0.0);
  std::vector<double> seconds, all(times.size());
  for (std::size_t k = 0; k < times.size(); k++) {
    seconds.push_back(times[k].seconds - seconds_before_[k]);
    seconds_before_[k] = times[k].seconds;
  }
  MPI_Reduce(seconds.data(), all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_SUM, 0, world);
  const double sum = std::accumulate(all.begin(), all.end(), 0.0);
  if (comm->me != 0 || sum <= 0.0) return;
  std::string text;
  for (std::size_t k = 0; k < times.size(); k++) {
    char share[16];
    snprintf(share, sizeof share, " %.0f %%", 100.0 * all[k] / sum);
    text += (text.empty() ? "fluid: " : ", ") + std::string(times[k].name) + share;
  }
  for (FILE *file : {screen, logfile})
    if (file) fprintf(file, "%s\n", text.c_str());
}
