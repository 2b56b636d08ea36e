// The springs of one object: between neighbours of its ring, and from ring to hub; free of LIGGGHTS.
#pragma once

#include <vector>

#include "springs.h"

namespace swellflow {

struct Spring {
  double length = 0.0, stiffness = 0.0, dashpot = 0.0;  ///< natural length L, k, c as they are now
};

/// Factors that all springs of an object share.
struct SpringScale {
  double length = 1.0, stiffness = 1.0, dashpot = 1.0;

  Spring operator*(const Spring &spring) const { return {length * spring.length, stiffness * spring.stiffness, dashpot * spring.dashpot}; }
};

/// Many springs, each property in a row of its own, as processors like it. Behind the last there is room that makes up whole blocks, with springs that do nothing.
class SpringColumns {
public:
  static constexpr int block = 8;

  int size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void resize(int n)
  {
    size_ = n;
    room_ = (n + block - 1) / block * block;
    columns_.assign(3 * static_cast<std::size_t>(room_), 0.0);
  }
  void assign(int n, const Spring &spring)
  {
    resize(n);
    for (int k = 0; k < n; ++k) set(k, spring);
  }
  void set(int k, const Spring &spring)
  {
    columns_[k] = spring.length;
    columns_[room_ + k] = spring.stiffness;
    columns_[2 * room_ + k] = spring.dashpot;
  }
  Spring operator[](int k) const { return {length()[k], stiffness()[k], dashpot()[k]}; }

  const double *length() const { return columns_.data(); }
  const double *stiffness() const { return columns_.data() + room_; }
  const double *dashpot() const { return columns_.data() + 2 * room_; }

private:
  int size_ = 0, room_ = 0;
  std::vector<double> columns_;  // one after the other
};

struct SpringSet {
  SpringColumns ring;    ///< ring[k]: from ring point k to k + 1, the last to 0
  SpringColumns spokes;  ///< spokes[k]: from ring point k to the hub, whose number is that of ring points; empty: none

  int ring_points() const { return ring.size(); }
  bool has_spokes() const { return !spokes.empty(); }
  /// Points that springs hold: the hub only when it has spokes.
  int held_points() const { return ring_points() + (has_spokes() ? 1 : 0); }
};

/// visit(a, b, spring), each spring once.
template <typename Visit>
void for_each_spring(const SpringSet &springs, const Visit &visit)
{
  const int n = springs.ring_points();
  for (int k = 0; k < n; ++k) {
    visit(k, k + 1 < n ? k + 1 : 0, springs.ring[k]);
    if (springs.has_spokes()) visit(k, n, springs.spokes[k]);
  }
}

}  // namespace swellflow
