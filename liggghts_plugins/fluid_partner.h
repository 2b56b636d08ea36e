// What a fix needs of a fluid, and nothing more: no grid, no dimension, no solver. The coupling implements it.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace swellflow {

/// One object as this rank sees it: indices into LIGGGHTS' per-atom arrays, own points or ghosts (the image nearest the hub).
struct ObjectPoints {
  int hub;
  const int *ring;  ///< n_ring indices, counter-clockwise
  int n_ring;
  bool absorbs = false;  ///< it drinks what it swells by: the fluid crosses its outline at the speed of swelling
  bool inflates = false; ///< it swells and does not drink: it pushes the fluid away
  double spring_frequency = 0.0;  ///< [1/time] with which springs let its size swing
};

/// What a side of the box does; the sides are in LIGGGHTS' order xlo, xhi, ylo, yhi, zlo, zhi.
enum class SideKind {
  wall,      ///< no-slip; moves within its plane
  slip,      ///< free-slip
  periodic,  ///< where the script's `boundary` says p
  inflow,    ///< velocity given, uniform
  parabolic_inflow,  ///< velocity given at the middle of the side, zero at its ends
  outflow    ///< velocity carried out (convective condition), corrected so that as much leaves as enters
};

enum class AdvectionScheme { central, bounded, none };
enum class ForcingScheme { direct, multi, implicit };

/// By direction; the third is zero in 2-D.
using Triple = std::array<double, 3>;

/// What drives the fluid during a step, as the script's variables give it for the end of that step.
struct FluidDrive {
  Triple gravity{};                     ///< acceleration of the points; only their buoyancy is the fluid's matter
  std::array<Triple, 6> side_velocity{};  ///< by side: of a wall, of an inflow (parabolic: at its middle)
  Triple body_force{};                  ///< per mass of fluid [length/time^2]; a pressure drop over a periodic box is drop / (density * length)
  Triple mean_velocity{};               ///< asked for in the directions of FluidOptions::controlled
  bool some_inflate = false;            ///< whether there may be objects anywhere that inflate
};

/// The fluid as a script describes it. Lengths, times and masses in the units of the script; 2-D is per unit depth.
struct FluidOptions {
  std::array<int, 3> cells{0, 0, 0};                  ///< across the box, per direction; 0 in a direction that is not solved
  double density = 0.0;
  double kinematic_viscosity = 0.0;
  int dem_steps_per_fluid_step = 1;                   ///< with cfl > 0: the most there may be
  double cfl = 0.0;                                   ///< 0: every step has dem_steps_per_fluid_step; else as many as keep the CFL number below this
  std::array<SideKind, 6> sides{};                    ///< by side
  std::array<bool, 3> controlled{};                   ///< periodic directions in which the mean velocity is held
  Triple initial_velocity{};                          ///< of all fluid, before the first step
  std::optional<int> linear_start;                    ///< instead: from the velocity of the wall at the lower end of this direction linearly to that at its upper end
  std::array<Triple, 6> initial_side_velocity{};      ///< by side, then
  AdvectionScheme advection = AdvectionScheme::central;
  ForcingScheme forcing = ForcingScheme::direct;
  int forcing_loops = 1;                              ///< of ForcingScheme::multi
  std::string kernel = "roma_1999";                   ///< roma_1999, peskin_2002, yang_2009, gruninger_2025
  std::optional<double> retraction;                   ///< of the markers, towards the hub, in cells; none given: that of the kernel
  int projections = 2;                                ///< in a step: 2 when the prediction is made divergence-free before it meets the markers
  double marker_gap = 1.0;                            ///< largest natural distance of markers along the ring, in cells
};

/// Values that thermo_style shows as f_ID[n]; the order is that of fix fluid/ib's page.
struct FluidReport {
  double mean_slip = 0.0, max_slip = 0.0, max_divergence = 0.0, cfl = 0.0, kinetic_energy = 0.0;
  Triple force_on_objects{};
  double momentum_error = 0.0;   ///< |given to the fluid + received by the objects| / sum |J|
  double marker_gap = 0.0;       ///< largest distance between neighbouring markers, in cells
  double step = 0.0;             ///< length of the last fluid step
  Triple mean_velocity{};        ///< of the whole box, what is inside objects included
  Triple driving_force{};        ///< body force per volume [pressure/length], that of the flow-rate controller included
  Triple force_of_sides{};       ///< of all sides of the box on the fluid, in the mean over the step: pressure, shear, and the momentum of what flows through
  Triple momentum{};             ///< of all fluid in the box, what is inside objects included
  double outflow = 0.0;          ///< volume that leaves through the sides less what enters, per time
  Triple force_of_growth{};      ///< momentum that the fluid has which appears inside objects that inflate, per time
};

/// Wall time of one phase of the step on this rank, since the partner was made.
struct PhaseTime {
  const char *name;
  double seconds;
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

/// What a scalar does at a side of the box.
enum class ScalarSideKind {
  open,   ///< nothing diffuses through it, what flows in has the value of the cell that it comes to; a periodic side: the scalar is periodic
  feed,   ///< the same, but what flows in has the value given; a periodic direction with such a side is cut: what leaves is gone
  value   ///< the value given holds there
};

/// A quantity that the fluid carries, as a script describes it.
struct ScalarOptions {
  std::string name;                               ///< of its field
  double diffusivity = 0.0;                       ///< length^2/time
  std::array<ScalarSideKind, 6> sides{};          ///< by side
  std::function<double(const Triple &)> initial;  ///< by place: that of the cell's centre
};

/// Of the whole box; amounts are values times area (2-D), those of the last four summed up since the scalar was made.
struct ScalarReport {
  double total = 0.0, mean = 0.0, smallest = 0.0, largest = 0.0;
  double entered = 0.0, left = 0.0;  ///< through the sides
  double withdrawn = 0.0;            ///< by objects
  double appeared = 0.0;             ///< with fluid that appears inside objects that inflate
  double balance_error = 0.0;        ///< what the total differs from what it was and these make of it, over the sum of their magnitudes
  int sub_steps = 0;                 ///< of the last step
};

/// What the markers on the outline met, summed over those of a point: value times spacing, and spacing [length].
struct ScalarMet {
  double amount = 0.0, spacing = 0.0;
};

class ScalarPartner {
public:
  virtual ~ScalarPartner() = default;
  /// Takes the scalar through the fluid step that has just been finished. side_values: by side, at its end. withdrawal [length], by own point (null, on all ranks alike: none): the
  /// markers of the point take out, by their spacing, this times the value that they then meet. met: by own point. Throws NotFinite. Collective.
  virtual void step(const std::array<double, 6> &side_values, const std::vector<double> *withdrawal, std::vector<ScalarMet> &met) = 0;
  /// The values of the cells at these places. Collective.
  virtual std::vector<double> values_at(const std::vector<Triple> &places) = 0;
  virtual ScalarReport report() = 0;  ///< collective
};

/// The flow, or a scalar, has blown up. Thrown on all ranks alike.
struct NotFinite : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class FluidPartner {
public:
  virtual ~FluidPartner() = default;
  /// How many DEM steps of length dem_dt the coming fluid step should have: at least 1. `drive`: as it is after one of them. Collective.
  virtual int choose_dem_steps(double dem_dt, const FluidDrive &drive) = 0;
  /// Before the first of dem_steps DEM steps: the fluid is predicted and the points' drag law for these steps is set. Collective.
  virtual void begin_step(const std::vector<ObjectPoints> &objects, const FluidDrive &drive, int dem_steps) = 0;
  /// Then, when ghosts have that law: the fluid inside each object becomes part of it.
  virtual void complete_law(const std::vector<ObjectPoints> &objects, const FluidDrive &drive) = 0;
  /// Before each later one, of this number from 0 on, where there are heavy objects: what of the law answers to how they have moved in the fluid step.
  virtual void press_again(const std::vector<ObjectPoints> &, int /*dem_step*/) {}
  /// After the last of them: what the points received goes to the fluid, which is made divergence-free. Throws NotFinite. Collective.
  virtual void finish_step(const std::vector<ObjectPoints> &objects) = 0;
  virtual FluidReport report() = 0;  ///< of the last whole fluid step; collective
  virtual double mean_slip() const { return 0.0; }  ///< the same as in the report
  /// Of the flow as it is, over the cells: the largest sum of the magnitudes of the components. Collective.
  virtual double largest_speed() = 0;
  /// Another field that the fluid carries, which it keeps; whether it goes on as it was in the file that the fluid was loaded from. Collective.
  virtual bool add_scalar(const ScalarOptions &) = 0;
  virtual void remove_scalar(const std::string &name) = 0;
  virtual ScalarPartner *scalar(const std::string &name) = 0;  ///< null when there is none
  /// Appends its state between two steps to a file, which rank 0 writes. Throws std::runtime_error on all ranks when it cannot. Collective.
  virtual void save(const std::string &file) = 0;
  /// Takes it from there, bytes `begin` to `end`, before the first step. Throws std::invalid_argument when that was another fluid. Collective.
  virtual void load(const std::string &file, long begin, long end) = 0;
  virtual FieldBlock field_block() const = 0;
  virtual std::vector<FieldInfo> fields() const = 0;
  virtual void copy_field(const std::string &name, std::vector<double> &values) const = 0;  ///< components interleaved
  virtual std::vector<PhaseTime> phase_times() const = 0;
  virtual double seconds_in_fluid() const = 0;
  virtual double seconds_in_coupling() const = 0;
};

/// Made by the program, handed to the fix: `lammps` is the library's handle. Throws std::invalid_argument with rule, value, remedy.
using FluidPartnerFactory = std::function<std::unique_ptr<FluidPartner>(void *lammps, const FluidOptions &)>;

}  // namespace swellflow
