// What is measured of an object, and what of many objects together; free of LIGGGHTS.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "unit_names.h"

namespace swellflow {

/// In the units of the script; masses, forces and energies per unit depth. Plain data, so that ranks can send it.
struct ObjectMeasures {
  using Plane = std::array<double, 2>;

  int id = 0;                      ///< the molecule id
  Plane centroid{};                ///< of the area in the outline, where the hub is in a periodic box
  Plane velocity{};                ///< of the centre of mass
  double rotation = 0.0;           ///< since the object was made, whole turns included; > 0 counter-clockwise
  double spin = 0.0;               ///< angular momentum over moment of inertia, about the centre of mass
  double mean_diameter = 0.0;      ///< twice the mean distance of the outline from the hub (Guinea, Toriu and Ushijima 2022, section 3.1)
  double diameter_of_area = 0.0;   ///< see swellflow::diameter_of_area
  double natural_diameter = 0.0, swelling_ratio = 1.0;
  double area = 0.0;               ///< in the outline; < 0 when it is inside out
  double area_ratio = 0.0;         ///< over that of the undeformed object at its swelling ratio
  double aspect_ratio = 1.0;
  double mass = 0.0;
  double spring_energy = 0.0, kinetic_energy = 0.0;  ///< of its springs, and of all its points
  double contact_force = 0.0;      ///< sum of the magnitudes over its points
  Plane net_contact_force{};
  double contact_pressure = 0.0;   ///< > 0 when squeezed
  int coordination = 0;            ///< other objects, and other atoms, that it touches
  double concentration = 0.0, uptake = 0.0;  ///< of the first scalar of the scene, at its outline; taken up so far
};

/// Visits all that is a value, in the order in which files list it: visit(name, unit, pointer to member).
template <typename Visit>
void for_each_measure(const UnitNames &units, const Visit &visit)
{
  using M = ObjectMeasures;
  visit("velocity", units.velocity, &M::velocity);
  visit("rotation", "rad", &M::rotation);
  visit("spin", units.spin, &M::spin);
  visit("mean_diameter", units.length, &M::mean_diameter);
  visit("diameter_of_area", units.length, &M::diameter_of_area);
  visit("natural_diameter", units.length, &M::natural_diameter);
  visit("swelling_ratio", "1", &M::swelling_ratio);
  visit("area", units.area, &M::area);
  visit("area_ratio", "1", &M::area_ratio);
  visit("aspect_ratio", "1", &M::aspect_ratio);
  visit("mass", units.mass, &M::mass);
  visit("spring_energy", units.energy, &M::spring_energy);
  visit("kinetic_energy", units.energy, &M::kinetic_energy);
  visit("contact_force", units.force, &M::contact_force);
  visit("net_contact_force", units.force, &M::net_contact_force);
  visit("contact_pressure", units.pressure, &M::contact_pressure);
  visit("coordination", "1", &M::coordination);
  visit("concentration", "1", &M::concentration);
  visit("uptake", units.area, &M::uptake);
}

/// Sums over objects and largest values, which can be added up over parts of them.
struct MeasureTotals {
  enum Sum {
    NUMBER, DIAMETER, DIAMETER_OF_AREA, AREA, ASPECT_RATIO, SPRING_ENERGY, KINETIC_ENERGY, PRESSURE, FORCE, COORDINATION, ROTATION, VELOCITY_X, VELOCITY_Y,
    HEIGHT, N_SUMS
  };
  enum Largest { MINUS_AREA_RATIO, LARGEST_PRESSURE, LARGEST_ROTATION, N_LARGEST };

  std::array<double, N_SUMS> sum{};
  std::array<double, N_LARGEST> largest;  ///< -infinity when there is nothing

  explicit MeasureTotals(const std::vector<ObjectMeasures> &objects);
  double number() const { return sum[NUMBER]; }
  double mean(Sum which) const { return number() > 0.0 ? sum[which] / number() : 0.0; }
  double largest_or_0(Largest which) const { return number() > 0.0 ? largest[which] : 0.0; }
};

}  // namespace swellflow
