#include "packed_bodies.h"

#include <algorithm>
#include <cmath>

namespace swellflow {

namespace {

double gyration_of(const PackingItem &item, double size)
{
  double widest = 0.0;
  for (const Circle &circle : *item.cover) widest = std::max(widest, size * (circle.centre.norm() + circle.radius));
  return widest / std::sqrt(2.0);
}

}  // namespace

PackedBodies::PackedBodies(const PackingTask &task, double scale, std::vector<Placement> placements) : task_(task), placements_(std::move(placements))
{
  for (const Circle &circle : task.obstacles) {
    discs_.push_back({-1, Vector2::Zero(), circle.radius, 0.0});
    at_.push_back(circle.centre);
  }
  for (std::size_t body = 0; body < task.items.size(); ++body) {
    const PackingItem &item = task.items[body];
    const double size = scale * item.size;
    first_disc_.push_back(static_cast<int>(discs_.size()));
    gyration_.push_back(gyration_of(item, size));
    for (const Circle &circle : *item.cover)
      discs_.push_back({static_cast<int>(body), size * circle.centre, size * circle.radius + item.margin, size * circle.radius + item.wall_margin});
    mean_radius_ += (std::sqrt(2.0) * gyration_.back() + item.margin) / task.items.size();
  }
  first_disc_.push_back(static_cast<int>(discs_.size()));
  at_.resize(discs_.size());
  for (int body = 0; body < bodies(); ++body) place(body, placements_[body]);
}

Vector2 PackedBodies::place_of(int disc, const Placement &placement) const
{
  const Vector2 &offset = discs_[disc].offset;
  if (placement.angle == 0.0 || offset.isZero(0.0)) return placement.centre + offset;
  const double c = std::cos(placement.angle), s = std::sin(placement.angle);
  return placement.centre + Vector2(c * offset.x() - s * offset.y(), s * offset.x() + c * offset.y());
}

void PackedBodies::place(int body, const Placement &placement)
{
  placements_[body] = placement;
  for (int disc = first_disc_[body]; disc < first_disc_[body + 1]; ++disc) at_[disc] = place_of(disc, placement);
}

void PackedBodies::find_pairs(double skin)
{
  skin_ = skin;
  found_at_ = at_;
  std::vector<Circle> circles;
  for (std::size_t disc = 0; disc < discs_.size(); ++disc) circles.push_back({at_[disc], discs_[disc].radius + 0.5 * skin});
  pairs_.clear();
  for_each_overlapping_pair(circles, static_cast<int>(task_.obstacles.size()), task_.room->box(), [&](int i, int j, const Vector2 &) {
    if (discs_[i].body != discs_[j].body) pairs_.push_back({i, j});
  });
}

bool PackedBodies::pairs_are_stale() const
{
  if (found_at_.empty()) return true;
  for (std::size_t disc = task_.obstacles.size(); disc < discs_.size(); ++disc)
    if (too_far(static_cast<int>(disc), at_[disc])) return true;
  return false;
}

}  // namespace swellflow
