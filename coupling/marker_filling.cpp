// Markers inside an object, for one that is too light to be held by those on its outline.
#include <algorithm>
#include <cmath>

#include "coupling/marker_ring.h"
#include "liggghts_plugins/fix_objects.h"

namespace swellflow {

namespace {

/// Layers next to the outline that stay without markers: those there would answer to the force that the markers on the outline carry, and slip grow (docs/theory.md).
constexpr int kept_clear = 2;

/// A marker inside: between two ring points and the hub.
struct Place {
  int point[2];
  double share[3];  ///< of the two points and of the hub
  double area;
};

}  // namespace

/// Layer j of n lies at j / n of the way from the hub to the markers on the outline, and stands for the area between (j - 1/2) / n and (j + 1/2) / n. The force on a
/// marker is a sum over those that bear it, each with its own velocity in the law: together they are the marker's own velocity, however the object moves.
void MarkerRing::fill(const ObjectPoints &object, const DemEngine &points, double h)
{
  const double *x_hub = points.x[object.hub];
  const bool spokes = points.object_point[object.hub][LAMMPS_NS::FixObjects::SPOKES] != 0.0;
  double farthest = 0.0, to_points = 0.0, to_markers = 0.0;
  for (const int i : std::span(object.ring, object.n_ring)) to_points += std::hypot(points.x[i][0] - x_hub[0], points.x[i][1] - x_hub[1]) / object.n_ring;
  for (const Vector2 &marker : from_hub_) {
    farthest = std::max(farthest, marker.norm());
    to_markers += marker.norm() / size();
  }
  const int layers = std::max(1, static_cast<int>(std::ceil(farthest / h)));
  const int n_filled = std::max(1, layers - kept_clear);
  const double length = perimeter(), reach = to_points > 0.0 ? to_markers / to_points : 0.0;

  std::vector<std::pair<int, InnerMarker>> borne;
  const auto add = [&](const Place &place) {
    const int atom[] = {object.ring[place.point[0]], object.ring[place.point[1]], object.hub};
    InnerMarker marker{};
    for (int b = 0; b < 3; ++b)
      for (int d = 0; d < 2; ++d) {
        marker.x[d] += place.share[b] * points.x[atom[b]][d];
        marker.u[d] += place.share[b] * points.v[atom[b]][d];
      }
    const auto bear = [&](int bearer, double share) {
      marker.spacing = share * place.area / h;
      if (marker.spacing > 0.0) borne.emplace_back(bearer, marker);
    };
    for (int b = 0; b < 2; ++b) bear(place.point[b], place.share[b]);
    // Without spokes the hub bears nothing: it is in the middle of opposite points.
    if (spokes) bear(object.n_ring, place.share[2]);
    else
      for (const int opposite : {0, object.n_ring / 2}) bear((place.point[0] + opposite) % object.n_ring, 0.5 * place.share[2]);
  };
  for (int j = 0; j < n_filled; ++j) {
    const double f = static_cast<double>(j) / layers, outer = (j + 0.5) / layers, inner = j > 0 ? (j - 0.5) / layers : 0.0;
    const int n = std::max(1, static_cast<int>(std::ceil(length * f / h)));
    for (int i = 0; i < n; ++i) {
      const double along = (i + 0.5) / n * object.n_ring, t = along - std::floor(along), to_ring = std::min(1.0, f * reach);
      const int k = static_cast<int>(along) % object.n_ring;
      add({{k, (k + 1) % object.n_ring}, {to_ring * (1.0 - t), to_ring * t, 1.0 - to_ring}, area_ * (outer * outer - inner * inner) / n});
    }
  }

  inner_start_.assign(object.n_ring + 2, 0);
  for (const auto &[bearer, marker] : borne) ++inner_start_[bearer + 1];
  for (int k = 0; k <= object.n_ring; ++k) inner_start_[k + 1] += inner_start_[k];
  std::stable_sort(borne.begin(), borne.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
  inner_.clear();
  for (const auto &[bearer, marker] : borne) inner_.push_back(marker);
}

std::span<const MarkerRing::InnerMarker> MarkerRing::inner(int k) const
{
  if (inner_start_.empty()) return {};
  return {inner_.data() + inner_start_[k], inner_.data() + inner_start_[k + 1]};
}

}  // namespace swellflow
