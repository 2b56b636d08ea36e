#include "packing_room.h"

namespace swellflow {

RectangularRoom::RectangularRoom(const PlaneBox &box, const Vector2 &low, const Vector2 &high) : PackingRoom(box), low_(low), high_(high)
{
  for (int d = 0; d < 2; ++d) has_walls_[d] = !(box.periodic[d] && low[d] <= box.low[d] && high[d] >= box.high[d]);
}

bool RectangularRoom::contains(const Vector2 &x) const
{
  for (int d = 0; d < 2; ++d)
    if (has_walls_[d] && (x[d] < low_[d] || x[d] > high_[d])) return false;
  return true;
}

void RectangularRoom::walls_near(const Vector2 &x, double reach, std::vector<NearWall> &walls) const
{
  for (int d = 0; d < 2; ++d) {
    if (!has_walls_[d]) continue;
    const double above_low = x[d] - low_[d], below_high = high_[d] - x[d];
    if (above_low < reach) walls.push_back({Vector2::Unit(d), above_low});
    if (below_high < reach) walls.push_back({-Vector2::Unit(d), below_high});
  }
}

}  // namespace swellflow
