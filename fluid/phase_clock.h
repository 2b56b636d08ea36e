// Wall time by phase of the fluid's step.
#pragma once

#include <array>
#include <chrono>

namespace swellflow {

class PhaseClock {
public:
  enum Phase { prediction, solves, forcing, projection, halo, n_phases, outside = n_phases };
  static constexpr std::array<const char *, n_phases> names = {"prediction", "solves", "forcing", "projection", "halo"};

  /// From here to its end, time belongs to a phase; what it interrupts goes on afterwards.
  class Scope {
  public:
    Scope(PhaseClock &clock, Phase phase) : clock_(clock), before_(clock.enter(phase)) {}
    ~Scope() { clock_.enter(before_); }
    Scope(const Scope &) = delete;
    Scope &operator=(const Scope &) = delete;

  private:
    PhaseClock &clock_;
    Phase before_;
  };

  double seconds(Phase phase) const { return seconds_[phase]; }

private:
  Phase enter(Phase phase)
  {
    const auto now = std::chrono::steady_clock::now();
    seconds_[phase_] += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    const Phase before = phase_;
    phase_ = phase;
    return before;
  }

  std::array<double, n_phases + 1> seconds_{};
  Phase phase_ = outside;
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

}  // namespace swellflow
