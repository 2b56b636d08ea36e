// Moves whole objects: what integrators have in common that must know all points of an object at once.
#pragma once

#include <vector>

#include "fix.h"
#include "fluid_partner.h"
#include "objects/point_body.h"
#include "options.h"

namespace LAMMPS_NS {

class FixObjects;

/// Each rank with an own point of an object moves the whole object, with the same numbers, and keeps its own points. Outer forces accelerate it by velocity Verlet, half
/// a step before and half a step after; all else happens in between, in `move`. In a fluid the velocity at the end of a step has half of the fluid's impulse of the next
/// one, too, foreseen to be that of this one: else an object that falls steadily would show a velocity that is ahead by half a step of its weight.
class FixObjectIntegrator : public Fix {
 public:
  FixObjectIntegrator(class LAMMPS *, int, char **);

  int setmask() override;
  void post_create() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void final_integrate() override;
  int pack_comm(int n, int *list, double *buf, int pbc_flag, int *pbc) override;
  void unpack_comm(int n, int first, double *buf) override;

 protected:
  /// How outer forces act in the half steps: as they would accelerate a rigid body, what they do beyond that being left to `move`; or on each point by itself.
  enum class OuterForces { as_a_whole, point_by_point };
  void set_outer_forces(OuterForces way) { outer_forces_ = way; }
  void declare_spin(swellflow::Options &options);
  /// Whether the hub moves with the springs, or only follows the ring.
  bool hub_is_held(const swellflow::ObjectPoints &object) const;
  /// Moves `body` over a step: its positions and velocities and, in a fluid, the impulses. `excess`: the outer forces that are left to it.
  virtual void move(const swellflow::ObjectPoints &object, swellflow::PointBody &body, const std::vector<swellflow::Vector2> &excess) = 0;
  FixObjects *objects() const { return objects_; }

 private:
  enum Spin { FROZEN, BODY };
  /// What a rank must know of every point, its own or not.
  struct Outer {
    double fx, fy, torque, vx, vy, kappa, ax, ay;
  };
  static constexpr int OUTER_SIZE = sizeof(Outer) / sizeof(double);

  void require_points_only() const;
  bool acts_on(const swellflow::ObjectPoints &object) const;
  void collect_outer();
  void take_back_foreseen();
  void begin_ahead(const swellflow::ObjectPoints &object, double torque);
  void foresee_impulse(const swellflow::ObjectPoints &object);
  void add_foreseen(const swellflow::ObjectPoints &object);
  double gather(const swellflow::ObjectPoints &object);
  void scatter_positions(const swellflow::ObjectPoints &object, const double *origin);
  void scatter_velocities(const swellflow::ObjectPoints &object);
  template <typename Visit>
  void for_each_member(const swellflow::ObjectPoints &object, const Visit &visit) const;
  void kick_half_a_step(double torque);

  OuterForces outer_forces_;
  int spin_;
  FixObjects *objects_;
  double **law_, **impulse_, **ahead_;  // of the fluid, in this step; null without one
  std::vector<Outer> outer_;
  swellflow::PointBody body_;
  std::vector<swellflow::Vector2> excess_;
};

}  // namespace LAMMPS_NS
