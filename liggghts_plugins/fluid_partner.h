// What a fix needs of a fluid, and nothing more: no grid, no dimension, no solver. The coupling implements it.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace swellflow {

/// One object as this rank sees it: indices into LIGGGHTS' per-atom arrays, own points or ghosts (the image nearest the hub).
struct ObjectPoints {
  int hub;
  const int *ring;  ///< n_ring indices, counter-clockwise
  int n_ring;
  bool absorbs = false;  ///< it drinks what it swells by: the fluid crosses its outline at the speed of swelling
};

/// Sides of the box, in LIGGGHTS' order.
enum class Side { xlo, xhi, ylo, yhi, zlo, zhi };

/// The fluid as a script describes it. Lengths, times and masses in the units of the script; 2-D is per unit depth.
struct FluidOptions {
  std::array<int, 3> cells{0, 0, 0};                  ///< across the box, per direction; 0 in a direction that is not solved
  double density = 0.0;
  double kinematic_viscosity = 0.0;
  int dem_steps_per_fluid_step = 1;
  std::array<std::array<double, 3>, 6> wall_velocity{};  ///< by Side; zero: a wall at rest
  double retraction = 0.3;                            ///< of the markers, towards the hub, in cells
  double marker_gap = 1.0;                            ///< largest natural distance of markers along the ring, in cells
};

/// Values that thermo_style shows as f_ID[n]; the order is that of fix fluid/ib's page.
struct FluidReport {
  double mean_slip = 0.0, max_slip = 0.0, max_divergence = 0.0, cfl = 0.0, kinetic_energy = 0.0;
  std::array<double, 3> force_on_objects{};
  double momentum_error = 0.0;   ///< |given to the fluid + received by the objects| / sum |J|
  double marker_gap = 0.0;       ///< largest distance between neighbouring markers, in cells
};

/// The cells of this rank, for output: direction 0 runs fastest, then 1, then 2.
struct FieldBlock {
  std::array<int, 3> global_cells{1, 1, 1}, first{0, 0, 0}, count{1, 1, 1};
  std::array<double, 3> origin{};   ///< lower corner of the whole grid
  double spacing = 0.0;
};

struct FieldInfo {
  std::string name, unit;
  int components;  ///< 1 or 3
};

class FluidPartner {
public:
  virtual ~FluidPartner() = default;
  /// Before a run: points that have been in no fluid step yet feel their buoyancy from the start. Collective.
  virtual void weigh(const std::vector<ObjectPoints> &objects, const std::array<double, 3> &gravity) = 0;
  /// Before the first of N DEM steps: the fluid is predicted and the points' drag law for these steps is set. Collective.
  virtual void begin_step(const std::vector<ObjectPoints> &objects, const std::array<double, 3> &gravity) = 0;
  /// After the last of them: what the points received goes to the fluid, which is made divergence-free. Collective.
  virtual void finish_step(const std::vector<ObjectPoints> &objects) = 0;
  virtual FluidReport report() = 0;  ///< of the last whole fluid step; collective
  virtual FieldBlock field_block() const = 0;
  virtual std::vector<FieldInfo> fields() const = 0;
  virtual void copy_field(const std::string &name, std::vector<double> &values) const = 0;  ///< components interleaved
  virtual double seconds_in_fluid() const = 0;
  virtual double seconds_in_coupling() const = 0;
};

/// Made by the program, handed to the fix: `lammps` is the library's handle. Throws std::invalid_argument with rule, value, remedy.
using FluidPartnerFactory = std::function<std::unique_ptr<FluidPartner>(void *lammps, const FluidOptions &)>;

}  // namespace swellflow
