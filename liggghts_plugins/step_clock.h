// Wall time by what it was spent on, for the progress line.
#pragma once

#include <chrono>

namespace swellflow {

class StepClock {
public:
  enum Category { springs, swelling, integration, n_categories };

  /// Adds the time of its own life to a category.
  class Scope {
  public:
    Scope(StepClock &clock, Category category) : clock_(clock), category_(category), start_(now()) {}
    ~Scope() { clock_.seconds_[category_] += now() - start_; }
    Scope(const Scope &) = delete;
    Scope &operator=(const Scope &) = delete;

  private:
    StepClock &clock_;
    Category category_;
    double start_;
  };

  static double now()
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  double seconds(Category category) const { return seconds_[category]; }

private:
  double seconds_[n_categories] = {};
};

}  // namespace swellflow
