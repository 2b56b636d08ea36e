#include "random_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace swellflow {

namespace {

constexpr double easy_fraction = 0.4;  ///< of the room; discs of one size no longer find a place at 0.547
constexpr int most_tries = 1000;       ///< after so many, any place is as good: overlaps are relaxed later

double radius_of(const PackingItem &item) { return 0.5 * item.size + item.margin; }

/// By which discs are made smaller, so that each finds its place soon.
double shrinking(const PackingTask &task)
{
  double area = 0.0;
  for (const PackingItem &item : task.items) area += std::numbers::pi * radius_of(item) * radius_of(item);
  return std::min(1.0, std::sqrt(easy_fraction * task.room->area() / area));
}

/// Discs in square cells, each in all cells that it touches.
class Occupied {
public:
  Occupied(const PlaneBox &box, double cell) : box_(box)
  {
    for (int d = 0; d < 2; ++d) n_[d] = static_cast<int>(std::clamp(box.length()[d] / cell, 1.0, 4000.0));
    cells_.resize(static_cast<std::size_t>(n_[0]) * n_[1]);
  }

  void add(const Circle &disc)
  {
    for_each_cell(disc, [&](std::vector<Circle> &cell) {
      cell.push_back(disc);
      return true;
    });
  }
  bool is_free(const Circle &disc)
  {
    return for_each_cell(disc, [&](const std::vector<Circle> &cell) {
      return std::none_of(cell.begin(), cell.end(), [&](const Circle &other) { return box_.difference(other.centre, disc.centre).norm() < other.radius + disc.radius; });
    });
  }

private:
  /// Until `visit` says no; whether it never did.
  template <typename Visit>
  bool for_each_cell(const Circle &disc, const Visit &visit)
  {
    int first[2], last[2];
    for (int d = 0; d < 2; ++d) {
      const double width = box_.length()[d] / n_[d], at = disc.centre[d] - box_.low[d];
      first[d] = static_cast<int>(std::floor((at - disc.radius) / width));
      last[d] = std::min(static_cast<int>(std::floor((at + disc.radius) / width)), first[d] + n_[d] - 1);
      if (!box_.periodic[d]) first[d] = std::max(first[d], 0), last[d] = std::min(last[d], n_[d] - 1);
    }
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i)
        if (!visit(cells_[static_cast<std::size_t>((j + n_[1]) % n_[1]) * n_[0] + (i + n_[0]) % n_[0]])) return false;
    return true;
  }

  const PlaneBox &box_;
  int n_[2];
  std::vector<std::vector<Circle>> cells_;
};

Vector2 inside(const PackingRoom &room, RandomNumbers &random)
{
  const Vector2 low = room.low(), size = room.high() - low;
  for (int tries = 0; tries < 100000; ++tries) {
    const double share_x = random.next(), share_y = random.next();
    const Vector2 x = low + size.cwiseProduct(Vector2(share_x, share_y));
    if (room.contains(x)) return x;
  }
  throw std::invalid_argument("there must be space for objects, but no place is inside");
}

}  // namespace

std::vector<Vector2> random_places(const PackingTask &task, RandomNumbers &random)
{
  const double scale = shrinking(task);
  double widest = 0.0;
  for (const PackingItem &item : task.items) widest = std::max(widest, 2.0 * scale * radius_of(item));
  Occupied occupied(task.room->box(), widest);
  for (const Circle &obstacle : task.obstacles) occupied.add(obstacle);

  std::vector<Vector2> places;
  std::vector<NearWall> walls;
  for (const PackingItem &item : task.items) {
    Circle disc{Vector2::Zero(), scale * radius_of(item)};
    for (int tries = 0; tries < most_tries; ++tries) {
      disc.centre = inside(*task.room, random);
      walls.clear();
      task.room->walls_near(disc.centre, disc.radius, walls);
      if (walls.empty() && occupied.is_free(disc)) break;
    }
    occupied.add(disc);
    places.push_back(disc.centre);
  }
  return places;
}

}  // namespace swellflow
