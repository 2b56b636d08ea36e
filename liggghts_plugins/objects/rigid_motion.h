// One time step of an object that does not deform but may swell; free of LIGGGHTS.
#pragma once

#include <vector>

#include "point_body.h"

namespace swellflow {

/// How the fluid's law changes the motion `whole` of a rigid body that is at the places of this one, in the mean over a step of length dt.
RigidAcceleration drag_as_a_whole(const PointBody &body, const WholeMotion &whole, double dt);

/// Moves a rigid body over dt as its momentum, its angular momentum and the fluid's drag law tell (Uhlmann 2005, eqs. 18 to 24, with the sum of the forces on its
/// markers; the drag is taken implicitly here). Afterwards the points have the shape `rest`, which need not be centred but must have its present size, turned by
/// the angle of the body; their velocities are those of the rigid motion and of the growth from their size before. Mass and moment of inertia are those of the points.
void move_rigidly(PointBody &body, const std::vector<Vector2> &rest, double dt);

}  // namespace swellflow
