#include "packing_shake.h"

#include <algorithm>
#include <cmath>

namespace swellflow {

namespace {

constexpr int sweeps_with_the_same_amplitude = 10;

/// The neighbours of each circle, by the pairs found last.
class Neighbours {
public:
  Neighbours() = default;
  explicit Neighbours(const PackedBodies &bodies) : first_(bodies.discs().size() + 1, 0), of_(2 * bodies.pairs().size())
  {
    for (const auto &[i, j] : bodies.pairs()) ++first_[i + 1], ++first_[j + 1];
    for (std::size_t disc = 1; disc < first_.size(); ++disc) first_[disc] += first_[disc - 1];
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (const auto &[i, j] : bodies.pairs()) of_[next[i]++] = j, of_[next[j]++] = i;
  }
  const int *begin(int disc) const { return of_.data() + first_[disc]; }
  const int *end(int disc) const { return of_.data() + first_[disc + 1]; }

private:
  std::vector<int> first_, of_;
};

class Shaking {
public:
  explicit Shaking(PackedBodies &bodies) : bodies_(bodies), skin_(1.5 * bodies.mean_radius()) { find_neighbours(); }

  bool try_move(int body, const Placement &trial)
  {
    // Not a reason to refuse it: that would favour places with space about them.
    if (leaves_its_neighbours(body, trial)) find_neighbours();
    for (int disc = bodies_.first_disc(body); disc < bodies_.first_disc(body + 1); ++disc)
      if (!is_free(disc, bodies_.place_of(disc, trial))) return false;
    bodies_.place(body, trial);
    return true;
  }

private:
  void find_neighbours()
  {
    bodies_.find_pairs(skin_);
    neighbours_ = Neighbours(bodies_);
  }

  bool leaves_its_neighbours(int body, const Placement &trial) const
  {
    for (int disc = bodies_.first_disc(body); disc < bodies_.first_disc(body + 1); ++disc)
      if (bodies_.too_far(disc, bodies_.place_of(disc, trial))) return true;
    return false;
  }

  bool is_free(int disc, const Vector2 &x)
  {
    const PackedBodies::Disc &moved = bodies_.discs()[disc];
    for (const int *other = neighbours_.begin(disc); other != neighbours_.end(disc); ++other) {
      const double reach = moved.radius + bodies_.discs()[*other].radius;
      if (bodies_.task().room->box().difference(bodies_.at(*other), x).squaredNorm() < reach * reach) return false;
    }
    walls_.clear();
    bodies_.task().room->walls_near(x, moved.to_wall, walls_);
    return walls_.empty();
  }

  PackedBodies &bodies_;
  double skin_;
  Neighbours neighbours_;
  std::vector<NearWall> walls_;
};

}  // namespace

void shake(PackedBodies &bodies, int sweeps, RandomNumbers &random)
{
  const double longest = 0.4 * bodies.mean_radius();  // well within half of the skin
  double amplitude = 0.1 * bodies.mean_radius();
  Shaking shaking(bodies);
  for (int sweep = 0; sweep < sweeps;) {
    int moved = 0, tried = 0;
    for (int end = std::min(sweeps, sweep + sweeps_with_the_same_amplitude); sweep < end; ++sweep)
      for (int body = 0; body < bodies.bodies(); ++body, ++tried) {
        Placement trial = bodies.placements()[body];
        trial.centre.x() += amplitude * (2.0 * random.next() - 1.0);
        trial.centre.y() += amplitude * (2.0 * random.next() - 1.0);
        if (bodies.task().turning) trial.angle += amplitude * (2.0 * random.next() - 1.0) / bodies.gyration(body);
        moved += shaking.try_move(body, trial);
      }
    amplitude = std::min(longest, amplitude * (2 * moved < tried ? 0.7 : 1.3));  // about half of all moves shall succeed
  }
}

}  // namespace swellflow
