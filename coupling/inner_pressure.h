// The pressure of the fluid inside an object whose points are too heavy to be stopped by what the markers' forcing gives.
#pragma once

#include "coupling/dem_engine.h"
#include "liggghts_plugins/fluid_partner.h"

namespace swellflow {

/// The fluid inside cannot be pressed, but forcing answers to a ring of mass m that comes inwards as if a layer of fluid of the mass M_l had to be stopped: it takes sqrt(m / M_l) fluid
/// steps. Where that is long, the ring meets the pressure at once, some five times a fluid step, tau apart:
///
///     p = -f [ c_1 (e - e_before) + c_0 e ] A / (tau^2 sum of s_k^2 / m_k),   s_k half the distance of the two neighbours of point k,
///
/// which moves points of any masses on a ring of any shape so that e, what its area A has beyond that of the fluid inside, relative, is gone after some three times. As a pressure within
/// a closed line it has neither a sum nor a torque, and a fluid that cannot be pressed does not feel it. f is 1 for the heaviest, 0 where forcing, or springs, are quick enough; see
/// docs/theory.md, *Heavy rings*. 2-D, per unit depth.
class InnerPressure {
public:
  /// What is known of an object when a fluid step begins.
  struct Ring {
    double area;            ///< inside its outline
    double natural_change;  ///< relative: by which the fluid inside may follow that in this step, growth and what makes up for a difference to the natural area
    double layer_mass;      ///< of the fluid that forcing moves at once
  };
  /// A fluid step of the length dt begins, of as many DEM steps.
  void begin(double dt, int dem_steps);
  /// Then, for each object: takes note of what is inside, in the points' state. In the very first fluid step there is no pressure.
  void follow(const ObjectPoints &object, const Ring &ring, bool first, const DemEngine &points);
  /// Whether the pressure is due before the DEM step of this number in the fluid step, from 0 on.
  bool is_due(int dem_step) const { return dem_step % interval_ == 0; }
  /// The law of own points gets the pressure that the ring's area now asks for, in place of that before; `dem_step` as above.
  void press(const ObjectPoints &object, int dem_step, const DemEngine &points) const;

private:
  int interval_ = 1, dem_steps_ = 1;  // DEM steps from pressure to pressure, and in the fluid step
  double tau_ = 0.0;
  bool some_ = false;  // some object on this rank has a pressure in this fluid step
};

}  // namespace swellflow
