// Objects copied out of LIGGGHTS for one frame, and the few numbers that describe their shape.
#pragma once

#include <array>
#include <vector>

#include "liggghts_plugins/objects/outline.h"
#include "liggghts_plugins/output_partner.h"

namespace swellflow {

using Vec3 = std::array<double, 3>;

struct PointState {
  Vec3 x{}, velocity{}, force{};
  double mass = 0.0, cds_radius = 0.0;  ///< radius 0: no contact-detection sphere
  double outline_offset = 0.0;          ///< by which the outline lies beyond a ring point, away from the hub
  int tag = 0;
};

struct ObjectState {
  int id = 0;
  double natural_diameter = 0.0, swelling_ratio = 1.0;
  PointState hub;
  std::vector<PointState> ring;  ///< counter-clockwise

  double mass() const;
  Vec3 velocity() const;      ///< of the centre of mass
  Vec3 outer_force() const;   ///< sum over the points: springs cancel; contacts, walls and weight stay
  std::vector<Vector2> outline() const;  ///< its vertices, from the hub
  double mean_diameter() const;  ///< twice the mean distance of the outline from the hub (Guinea et al. 2022, section 3.1)
  OutlineShape shape() const;    ///< of the outline
};

/// Per-atom arrays through LIGGGHTS' library interface; taken anew for each frame because LIGGGHTS moves them.
std::vector<ObjectState> object_states(void *lammps, const OutputFrame &frame);

}  // namespace swellflow
