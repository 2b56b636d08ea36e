// Bodies made of circles that must not overlap, while they are being placed: where their circles are, and which are near each other. Free of LIGGGHTS.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "packing_room.h"

namespace swellflow {

/// A body to be placed: circles about its centre at size 1, its size, and how far it is to be kept away from others and from walls.
struct PackingItem {
  std::shared_ptr<const std::vector<Circle>> cover;
  double size = 1.0;
  double margin = 0.0;       ///< two bodies keep the sum of theirs
  double wall_margin = 0.0;
};

struct Placement {
  Vector2 centre = Vector2::Zero();
  double angle = 0.0;  ///< counter-clockwise
};

struct PackingTask {
  std::shared_ptr<const PackingRoom> room;
  std::vector<PackingItem> items;
  std::vector<Circle> obstacles;  ///< that stay where they are
  bool turning = false;           ///< bodies may be turned
  std::uint64_t seed = 0;
};

class PackedBodies {
public:
  struct Disc {
    int body;        ///< -1: an obstacle
    Vector2 offset;  ///< from the body's centre, unturned
    double radius;   ///< with the margin towards others
    double to_wall;  ///< least distance of the centre from a wall
  };
  struct Pair {
    int first, second;
  };

  /// Sizes are multiplied by `scale`; margins are not.
  PackedBodies(const PackingTask &task, double scale, std::vector<Placement> placements);

  const PackingTask &task() const { return task_; }
  const std::vector<Placement> &placements() const { return placements_; }
  void place(int body, const Placement &placement);  ///< moves its circles too
  double gyration(int body) const { return gyration_[body]; }
  double mean_radius() const { return mean_radius_; }
  int bodies() const { return static_cast<int>(placements_.size()); }

  const std::vector<Disc> &discs() const { return discs_; }
  int first_disc(int body) const { return first_disc_[body]; }
  const Vector2 &at(int disc) const { return at_[disc]; }
  Vector2 place_of(int disc, const Placement &placement) const;

  /// Finds the pairs of circles that are less than `skin` apart.
  void find_pairs(double skin);
  const std::vector<Pair> &pairs() const { return pairs_; }
  /// Whether a circle at `x` is so far from where pairs were found that it may have met another.
  bool too_far(int disc, const Vector2 &x) const { return (x - found_at_[disc]).squaredNorm() > 0.25 * skin_ * skin_; }
  bool pairs_are_stale() const;

private:
  const PackingTask &task_;
  std::vector<Placement> placements_;
  std::vector<double> gyration_;
  std::vector<Disc> discs_;        // of obstacles, then of the bodies
  std::vector<int> first_disc_;    // of each body, and one behind the last
  std::vector<Vector2> at_, found_at_;
  std::vector<Pair> pairs_;
  double skin_ = 0.0, mean_radius_ = 0.0;
};

}  // namespace swellflow
