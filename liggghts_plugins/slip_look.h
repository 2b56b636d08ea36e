// How many fluid steps of a run had more slip at outlines than a run that is right has.
#pragma once

#include <vector>

namespace swellflow {

class SlipLook {
public:
  static constexpr double bound = 0.05;  ///< of the largest speed up to then

  void begin() { *this = {}; }
  /// Of each fluid step.
  void add(double mean_slip)
  {
    constexpr int first = 10;  // in which fluid and objects meet
    if (++seen_ > first) open_.push_back(mean_slip);
  }
  /// Now and then, since speeds cost more: of all cells and points up to now.
  void settle(double largest_speed)
  {
    for (const double slip : open_) beyond_ += slip > bound * largest_speed;
    counted_ += open_.size();
    open_.clear();
  }
  long beyond() const { return beyond_; }
  double share() const { return counted_ > 0 ? static_cast<double>(beyond_) / counted_ : 0.0; }

private:
  long seen_ = 0, counted_ = 0, beyond_ = 0;
  std::vector<double> open_;
};

}  // namespace swellflow
