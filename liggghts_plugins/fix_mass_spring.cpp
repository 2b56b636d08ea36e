#include "fix_mass_spring.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_objects.h"
#include "fix_property_atom.h"
#include "integrators.h"
#include "modify.h"
#include "objects/csv_table.h"
#include "options.h"
#include "text_file.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using swellflow::ObjectPoints;
using swellflow::Range;
using swellflow::Vector2;

/* ---------------------------------------------------------------------- */

FixMassSpring::FixMassSpring(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), restitution_(1.0), objects_(nullptr), dashpot_(nullptr), dashpot_step_(-1), solved_groups_(0), explicit_groups_(0),
    totals_step_(-1), natural_of_list_(-1)
{
  swellflow::or_stop(lmp, [&] { parse(narg, arg); });
  law_.damping = swellflow::damping_ratio(restitution_);
  restart_global = 1;
  scalar_flag = vector_flag = 1;
  size_vector = 4;
  global_freq = 1;
  extscalar = 1;
  extvector = 0;
}

void FixMassSpring::parse(int narg, char **arg)
{
  swellflow::Arguments line(std::string("fix ") + id + " mass_spring", narg - 3, arg + 3);
  swellflow::Options options(line.place());
  int lengths = 0;
  options.number("stiffness", law_.stiffness, Range::positive(), "force per length", "stiffness of every spring");
  options.number("modulus", law_.modulus, Range::positive(), "force", "tension over strain: the stiffness of a spring is modulus / natural length");
  options.number("restitution", restitution_, Range::above_to(0.0, 1.0), "", "speed after over speed before, for a bonded pair");
  options.choice("lengths", lengths, {"natural", "zero"}, "natural lengths: those at creation times the swelling ratio, or none");
  options.custom("stiffening", [this](swellflow::Arguments &rest) { read_stiffening(rest); },
                 "power N or table FILE: stiffness over that of the unswollen object as a function of the swelling ratio");
  options.parse(line);
  if (options.given("stiffness") == options.given("modulus"))
    line.fail("springs want one of the keywords 'stiffness' and 'modulus', but got " +
              std::string(options.given("modulus") ? "both: leave one out" : "neither: add one"));
  law_.zero_lengths = lengths == 1;
}

void FixMassSpring::read_stiffening(swellflow::Arguments &line)
{
  if (line.choice("stiffening", {"power", "table"}) == 0) {
    law_.stiffening.power = line.number("stiffening power");
    return;
  }
  const std::string file = line.word("stiffening table");
  const swellflow::CsvTable table(file, text_of_file(lmp, line.place(), file), {"ratio", "factor"});
  const auto fail = [&](const swellflow::CsvTable::Row &row, const std::string &message) { throw swellflow::OptionError(table.place(row) + ": " + message); };
  for (const char *column : {"ratio", "factor"})
    if (!table.has(column)) line.fail("the table of 'stiffening' must have the columns ratio and factor, but '" + file + "' lacks '" + column + "': add it");
  auto &rows = law_.stiffening.table;
  for (const auto &row : table.rows()) {
    const double ratio = *table.value(row, "ratio"), factor = *table.value(row, "factor");
    if (!Range::positive().holds(factor)) fail(row, "'factor' must be a number > 0, but is '" + swellflow::shown(factor) + "': change it");
    if (!rows.empty() && ratio <= rows.back().first)
      fail(row, "'ratio' must rise from line to line, but " + swellflow::shown(ratio) + " follows " + swellflow::shown(rows.back().first) + ": sort the table");
    rows.emplace_back(ratio, factor);
  }
  if (rows.empty()) line.fail("the table of 'stiffening' must have a line of values, but '" + file + "' has none: add some");
}

int FixMassSpring::setmask() { return POST_FORCE; }

void FixMassSpring::post_create()
{
  objects_ = require_objects(lmp, *this);
  if (!damped() || modify->find_fix(dashpot_property().c_str()) >= 0) return;
  const std::string name = dashpot_property();
  const char *arguments[] = {name.c_str(), "all", "property/atom", name.c_str(), "vector", "yes", "no", "no", "0", "0"};
  modify->add_fix(10, const_cast<char **>(arguments));
  // LIGGGHTS would write the zeros again at the first run.
  modify->fix[modify->find_fix(name.c_str())]->just_created = 0;
}

void FixMassSpring::pre_delete(bool unfixflag)
{
  if (unfixflag && modify->find_fix(dashpot_property().c_str()) >= 0) modify->delete_fix(dashpot_property().c_str());
}

void FixMassSpring::init()
{
  objects_ = require_objects(lmp, *this);
  totals_step_ = -1;
  find_integrators();
  if (!damped()) return;
  dashpot_ = static_cast<FixPropertyAtom *>(modify->fix[modify->find_fix(dashpot_property().c_str())]);
  if (!comm->ghost_velocity)
    error->fix_error(FLERR, this, ("a dashpot needs its partner's velocity, but ghosts have none (restitution is " +
                                   swellflow::shown(restitution_) + "): add 'communicate single vel yes'").c_str());
}

void FixMassSpring::find_integrators()
{
  solved_groups_ = explicit_groups_ = 0;
  for (int k = 0; k < modify->nfix; k++) {
    const Fix &fix = *modify->fix[k];
    if (solves_springs(fix)) solved_groups_ |= fix.groupbit;
    else if (takes_springs_as_forces(fix)) explicit_groups_ |= fix.groupbit;
  }
}

/* ----------------------------------------------------------------------
   Within a step forces are made with the velocities of the half step,
   which are gone when a run begins: the dashpots' force is kept, so that
   a run in two parts, or from a restart file, is equal to one run.
------------------------------------------------------------------------- */

void FixMassSpring::setup(int)
{
  objects_->require_whole_objects(*this);
  if (damped()) forget_dashpots_of_solved_objects();
  const bool kept = damped() && dashpot_step_ == update->ntimestep;
  add_forces(damped() && !kept);
  for (int i = 0; kept && i < atom->nlocal; i++)
    for (int d = 0; d < 2; d++) atom->f[i][d] += dashpot_->array_atom[i][d];
}

/// They were kept in the last run, when another fix may have moved these objects.
void FixMassSpring::forget_dashpots_of_solved_objects()
{
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & solved_groups_) dashpot_->array_atom[i][0] = dashpot_->array_atom[i][1] = 0.0;
}

void FixMassSpring::post_force(int)
{
  swellflow::StepClock::Scope timing(objects_->clock(), swellflow::StepClock::springs);
  totals_step_ = -1;  // a variable may have asked for the values of this step before it came
  // Objects that shrink, or stiffen as they swell, vibrate ever faster; beyond the limit a disturbance grows by a third a step.
  constexpr bigint steps_between_checks = 100;
  if (update->ntimestep % steps_between_checks == 0) judge_step();
  add_forces(damped());
}

/* ---------------------------------------------------------------------- */

bool FixMassSpring::acts_on(const ObjectPoints &object) const { return atom->mask[object.hub] & groupbit; }

bool FixMassSpring::gives_forces_to(const ObjectPoints &object) const
{
  return acts_on(object) && !(atom->mask[object.hub] & solved_groups_);
}

const swellflow::SpringSet &FixMassSpring::springs_of(const ObjectPoints &object) const
{
  const swellflow::SpringScale scale = scale_of(object);
  springs_ = natural_springs(object);
  for (auto *springs : {&springs_.ring, &springs_.spokes})
    for (int k = 0; k < springs->size(); k++) springs->set(k, scale * (*springs)[k]);
  return springs_;
}

/* ----------------------------------------------------------------------
   as the objects were made; kept until there is a new list of objects
------------------------------------------------------------------------- */

const swellflow::SpringSet &FixMassSpring::natural_springs(const ObjectPoints &object) const
{
  const std::vector<ObjectPoints> &objects = objects_->objects();
  if (natural_of_list_ != objects_->list_number()) {
    natural_.resize(objects.size());
    for (std::size_t k = 0; k < objects.size(); k++) find_natural_springs(objects[k], natural_[k]);
    natural_of_list_ = objects_->list_number();
  }
  return natural_[&object - objects.data()];
}

void FixMassSpring::find_natural_springs(const ObjectPoints &object, swellflow::SpringSet &springs) const
{
  using enum FixObjects::Column;
  using enum FixObjects::SizeColumn;
  double **points = objects_->points(), **sizes = objects_->sizes();
  const double *hub = points[object.hub];
  springs.ring.resize(object.n_ring);
  springs.spokes.resize(hub[SPOKES] != 0.0 ? object.n_ring : 0);
  for (int k = 0; k < object.n_ring; k++) {
    const int a = object.ring[k], b = object.ring[k + 1 < object.n_ring ? k + 1 : 0];
    springs.ring.set(k, law_.natural(points[a][RING_LENGTH], sizes[a][MASS], sizes[b][MASS]));
    if (springs.has_spokes()) springs.spokes.set(k, law_.natural(points[a][SPOKE_LENGTH], sizes[a][MASS], sizes[object.hub][MASS]));
  }
}

/// The first ring point speaks for all.
swellflow::SpringScale FixMassSpring::scale_of(const ObjectPoints &object) const
{
  const int i = object.ring[0];
  const double *size = objects_->sizes()[i];
  return law_.scale(size[FixObjects::LAMBDA], atom->rmass[i] / size[FixObjects::MASS]);
}

/* ----------------------------------------------------------------------
   f(own point i, its number k in the object): forces_ has the forces of
   that object. A point may be here as an image while its own atom lies at
   the other side of a periodic box.
------------------------------------------------------------------------- */

template <typename F>
void FixMassSpring::for_each_force(bool with_dashpots, const F &f) const
{
  const int n_own = atom->nlocal;
  const auto visit = [&](int i, int k) {
    if (const int own = i < n_own ? i : objects_->own_index(i); own >= 0) f(own, k);
  };
  for (const ObjectPoints &object : objects_->objects()) {
    if (!gives_forces_to(object)) continue;
    forces_.gather(object.ring, object.n_ring, object.hub, atom->x[0], with_dashpots ? atom->v[0] : nullptr);
    forces_.find(natural_springs(object), scale_of(object));
    for (int k = 0; k < object.n_ring; k++) visit(object.ring[k], k);
    visit(object.hub, object.n_ring);
  }
}

/// The dashpots' forces are kept where they are wanted, and added after those of the springs, as a run does that begins with what was kept.
void FixMassSpring::add_forces(bool with_dashpots)
{
  double **f = atom->f;
  if (!with_dashpots) {
    for_each_force(false, [f, this](int i, int k) {
      for (int d = 0; d < 2; d++) f[i][d] += forces_.springs(d)[k];
    });
    return;
  }
  double **kept = dashpot_->array_atom;
  for_each_force(true, [f, kept, this](int i, int k) {
    for (int d = 0; d < 2; d++) {
      kept[i][d] = forces_.dashpots(d)[k];
      f[i][d] = f[i][d] + forces_.springs(d)[k] + kept[i][d];
    }
  });
  dashpot_step_ = update->ntimestep;
}

void FixMassSpring::add_given(double *own_xy) const
{
  for_each_force(false, [own_xy, this](int i, int k) {
    for (int d = 0; d < 2; d++) own_xy[2 * i + d] += forces_.springs(d)[k];
  });
  if (!damped() || dashpot_step_ != update->ntimestep) return;
  for (int i = 0; i < atom->nlocal; i++)
    for (int d = 0; d < 2; d++) own_xy[2 * i + d] += dashpot_->array_atom[i][d];
}

/* ---------------------------------------------------------------------- */

void FixMassSpring::reset_timestep(bigint new_step, bigint old_step)
{
  if (dashpot_step_ >= 0) dashpot_step_ += new_step - old_step;
}

void FixMassSpring::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  const double state = static_cast<double>(dashpot_step_);
  const int size = sizeof state;
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&state, sizeof(double), 1, fp);
}

void FixMassSpring::restart(char *buffer) { dashpot_step_ = static_cast<bigint>(*reinterpret_cast<double *>(buffer)); }
