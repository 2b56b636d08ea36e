// Where objects may be placed. Free of LIGGGHTS.
#pragma once

#include <vector>

#include "overlap.h"

namespace swellflow {

/// A wall as seen from a place near it.
struct NearWall {
  Vector2 inwards;   ///< unit normal that leads into the room
  double distance;   ///< < 0: the place is outside
};

class PackingRoom {
public:
  explicit PackingRoom(const PlaneBox &box) : box_(box) {}
  virtual ~PackingRoom() = default;

  const PlaneBox &box() const { return box_; }
  virtual Vector2 low() const = 0;   ///< of a rectangle about the room
  virtual Vector2 high() const = 0;
  virtual double area() const = 0;
  virtual bool contains(const Vector2 &x) const = 0;
  /// Adds the walls of which `x` is less than `reach` away, or outside.
  virtual void walls_near(const Vector2 &x, double reach, std::vector<NearWall> &walls) const = 0;

private:
  PlaneBox box_;
};

/// A rectangle in the box. Where it spans a periodic box it has no walls.
class RectangularRoom : public PackingRoom {
public:
  RectangularRoom(const PlaneBox &box, const Vector2 &low, const Vector2 &high);
  /// The whole box.
  explicit RectangularRoom(const PlaneBox &box) : RectangularRoom(box, box.low, box.high) {}

  Vector2 low() const override { return low_; }
  Vector2 high() const override { return high_; }
  double area() const override { return (high_ - low_).prod(); }
  bool contains(const Vector2 &x) const override;
  void walls_near(const Vector2 &x, double reach, std::vector<NearWall> &walls) const override;

private:
  Vector2 low_, high_;
  bool has_walls_[2];
};

}  // namespace swellflow
