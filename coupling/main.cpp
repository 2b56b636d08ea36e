// The program: LIGGGHTS through its library interface, with our styles beside its own.
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <string>

#include "coupling/coupled_fluid.h"
#include "coupling/output/vtk_output.h"
#include "failure.h"
#include "input.h"
#include "lammps.h"
#include "library.h"
#include "liggghts_plugins/liggghts_version.h"
#include "liggghts_plugins/register_styles.h"
#include "liggghts_plugins/stop_request.h"
#include "liggghts_plugins/stop_signals.h"

namespace {

using LAMMPS_NS::LAMMPS;

bool has_argument(int argc, char **argv, std::initializer_list<const char *> names)
{
  return std::any_of(argv + 1, argv + argc, [&](const char *arg) {
    return std::any_of(names.begin(), names.end(), [&](const char *name) { return std::strcmp(arg, name) == 0; });
  });
}

/// LIGGGHTS prints its own help and exits while it is being opened, so ours comes first.
void print_our_help()
{
  std::printf("swellflow %s: LIGGGHTS with a coupled fluid\n\n", SWELLFLOW_VERSION);
  std::printf("* Fix styles of swellflow:\n");
  for (const auto &name : swellflow::our_fix_styles()) std::printf("  %s\n", name.c_str());
  std::printf("* Command styles of swellflow:\n");
  for (const auto &name : swellflow::our_commands()) std::printf("  %s\n", name.c_str());
  std::printf("* Command line of swellflow: that of LIGGGHTS, below, and\n  --version                   : print the version\n\n");
  std::fflush(stdout);
}

void report(const LAMMPS *lmp, const char *message)
{
  std::fflush(nullptr);
  if (lmp == nullptr || lmp->screen != nullptr) std::printf("ERROR: %s\n", message);
  if (lmp != nullptr && lmp->logfile != nullptr) std::fprintf(lmp->logfile, "ERROR: %s\n", message);
  std::fflush(nullptr);
}

int run_script(int argc, char **argv, MPI_Comm failures)
{
  void *handle = nullptr;
  try {
    lammps_open(argc, argv, MPI_COMM_WORLD, &handle);
    auto *lmp = static_cast<LAMMPS *>(handle);
    swellflow::register_styles(lmp, {swellflow::make_coupled_fluid, swellflow::make_vtk_output});
    lmp->input->file();
    const bool stopped = report_stop(lmp);
    lammps_close(handle);
    MPI_Barrier(MPI_COMM_WORLD);
    if (stopped) swellflow::stop_signals::limit_finalize();
    return 0;
  } catch (const std::exception &error) {
    auto *lmp = static_cast<LAMMPS *>(handle);
    const std::string message = swellflow::message_of(error, lmp ? swellflow::command_of(lmp) : "");
    if (swellflow::agree_on_failure(failures, message)) report(lmp, message.c_str());
    return 1;
  }
}

}  // namespace

int main(int argc, char **argv)
{
  if (has_argument(argc, argv, {"--version"})) {
    std::printf("swellflow %s (LIGGGHTS %s)\n", SWELLFLOW_VERSION, swellflow::supported_liggghts);
    return 0;
  }
  // An error that ends all ranks at once would lose what is still in the buffer, its own message with it.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  swellflow::stop_signals::handle();
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0 && has_argument(argc, argv, {"-help", "-h"})) print_our_help();
  MPI_Comm failures;
  MPI_Comm_dup(MPI_COMM_WORLD, &failures);
  const int status = run_script(argc, argv, failures);
  MPI_Comm_free(&failures);
  MPI_Finalize();
  return status;
}
