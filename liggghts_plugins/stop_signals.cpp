#include "stop_signals.h"

#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <initializer_list>

namespace swellflow::stop_signals {

namespace {

// What a handler can reach.
volatile std::sig_atomic_t noted = nothing;
volatile double first_came = 0.0;

// One Ctrl-C, or one signal to a whole job, may reach a rank twice: by itself and through mpirun.
constexpr double same_signal = 0.5;

double now()
{
  timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void end_at_once()
{
  const char message[] = "\nA second signal: ending at once. The last complete restart file is as it was.\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message, sizeof message - 1);
  _Exit(EXIT_FAILURE);
}

void note(int signal)
{
  if (signal == SIGUSR1) {
    if (noted == nothing) noted = save;
    return;
  }
  if (noted != save_and_stop) {
    first_came = now();
    noted = save_and_stop;
  } else if (now() - first_came > same_signal) {
    end_at_once();
  }
}

}  // namespace

void handle()
{
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGUSR2}) sigaction(signal, &action, nullptr);
}

Wish wish() { return static_cast<Wish>(static_cast<int>(noted)); }

void agreed(Wish wish)
{
  if (wish == save_and_stop && noted != save_and_stop) {
    first_came = now();
    noted = save_and_stop;
  }
  if (wish == save && noted == save) noted = nothing;
}

void limit_finalize()
{
  struct sigaction action {};
  action.sa_handler = [](int) { _Exit(EXIT_SUCCESS); };
  sigaction(SIGALRM, &action, nullptr);
  const char *grace = std::getenv("OMPI_MCA_odls_base_sigkill_timeout");
  const double limit = std::clamp(0.3 * (grace ? std::atof(grace) : 1.0), 0.25, 5.0);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(limit);
  timer.it_value.tv_usec = static_cast<suseconds_t>(std::lround(1e6 * (limit - std::floor(limit))));
  setitimer(ITIMER_REAL, &timer, nullptr);
}

}  // namespace swellflow::stop_signals
