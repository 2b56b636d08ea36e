#include "point_body.h"

namespace swellflow {

void PointBody::resize(int n, bool in_fluid)
{
  x.resize(n);
  v.resize(n);
  mass.resize(n);
  force.resize(n);
  kappa.resize(in_fluid ? n : 0);
  a.resize(in_fluid ? n : 0);
  impulse.resize(in_fluid ? n : 0);
}

WholeMotion whole_motion(const PointBody &body)
{
  WholeMotion whole;
  for (int i = 0; i < body.size(); ++i) {
    whole.mass += body.mass[i];
    whole.centre += body.mass[i] * body.x[i];
    whole.velocity += body.mass[i] * body.v[i];
  }
  whole.centre /= whole.mass;
  whole.velocity /= whole.mass;
  for (int i = 0; i < body.size(); ++i) {
    const Vector2 r = body.x[i] - whole.centre;
    whole.inertia += body.mass[i] * r.squaredNorm();
    whole.angular_momentum += body.mass[i] * cross(r, body.v[i]);
  }
  return whole;
}

RigidAcceleration rigid_acceleration(const PointBody &body, const WholeMotion &whole, double torque)
{
  RigidAcceleration acceleration;
  for (int i = 0; i < body.size(); ++i) {
    acceleration.linear += body.force[i] / whole.mass;
    torque += cross(body.x[i] - whole.centre, body.force[i]);
  }
  acceleration.angular = torque / whole.inertia;
  return acceleration;
}

}  // namespace swellflow
