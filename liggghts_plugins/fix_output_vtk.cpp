// When frames are due, what they hold, and fresh values for the points that are ghosts on the rank that writes them.
#include "fix_output_vtk.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "atom.h"
#include "contact_forces.h"
#include "error.h"
#include "fix_fluid_ib.h"
#include "fix_objects.h"
#include "modify.h"
#include "object_measures.h"
#include "options.h"
#include "update.h"

using namespace LAMMPS_NS;

FixOutputVtk::FixOutputVtk(LAMMPS *lmp, int narg, char **arg, const swellflow::OutputPartnerFactory &make_partner) :
  Fix(lmp, narg, arg), times_(lmp)
{
  swellflow::or_stop(lmp, [&] {
    const std::string place = std::string("fix ") + arg[0] + " output/vtk";
    swellflow::Arguments arguments(place, narg - 3, arg + 3);
    swellflow::Options options(place);
    std::vector<std::string> objects;
    options.integer("every", nevery, swellflow::Range::at_least(1), "DEM steps between frames").required();
    options.text("folder", options_.folder, "folder of the files, made when it is missing");
    options.list("fields", options_.fields, {}, "fields of the fluid");
    options.list("objects", objects, {"outline", "points", "cds", "centres"}, "what to write of the objects");
    options.parse(arguments);
    for (const std::string &word : objects)
      (word == "outline" ? options_.outline : word == "points" ? options_.points : word == "cds" ? options_.cds : options_.centres) = true;
    if (!needs_fluid() && !needs_objects())
      arguments.fail("there is nothing to write: give fields (velocity pressure), objects (outline points cds centres) or both");
  });
  options_.units = update->unit_style;
  restart_global = 1;
  require_own_folder();
  try {
    partner_ = make_partner(lmp, options_);
  } catch (const std::runtime_error &failure) {
    error->fix_error(FLERR, this, failure.what());
  }
}

int FixOutputVtk::setmask() { return FixConst::END_OF_STEP; }

/// The first fix of that style, by its place in the script's order; -1 when there is none.
int FixOutputVtk::place_of(const char *other_style) const
{
  for (int i = 0; i < modify->nfix; i++)
    if (strcmp(modify->fix[i]->style, other_style) == 0) return i;
  return -1;
}

void FixOutputVtk::require_own_folder()
{
  for (int i = 0; i < modify->nfix; i++) {
    const auto *other = dynamic_cast<FixOutputVtk *>(modify->fix[i]);
    if (!other || other == this || strcmp(other->id, id) == 0 || other->options_.folder != options_.folder) continue;
    error->fix_error(FLERR, this, ("each output needs a folder of its own, but fix " + std::string(other->id) + " writes into '" +
                                   options_.folder + "' already: name another with the keyword folder").c_str());
  }
}

void FixOutputVtk::init()
{
  if (needs_objects()) require_objects(lmp, *this);
  if (options_.centres) require_whole_forces(lmp, *this);
  if (!needs_fluid()) return;
  const int fluid_place = place_of("fluid/ib");
  if (fluid_place < 0)
    error->fix_error(FLERR, this, "fields need a fluid, but there is no fix fluid/ib: add one or leave out the keyword fields");
  if (fluid_place > modify->find_fix(id))
    error->fix_error(FLERR, this, "the frame is written when the fluid's step is complete: put fix output/vtk after fix fluid/ib");
}

const swellflow::FluidPartner *FixOutputVtk::fluid() const
{
  const int place = place_of("fluid/ib");
  return place < 0 ? nullptr : dynamic_cast<FixFluidIb *>(modify->fix[place])->partner();
}

/// Only now: the fluid is made in the init() of its own fix.
void FixOutputVtk::require_fields()
{
  std::string known;
  for (const auto &field : fluid()->fields()) known += (known.empty() ? "" : ", ") + field.name;
  for (const std::string &name : options_.fields) {
    bool found = false;
    for (const auto &field : fluid()->fields()) found = found || field.name == name;
    if (!found)
      error->fix_error(FLERR, this, ("fields must name what the fluid has, but got '" + name + "': choose from " + known).c_str());
  }
}

void FixOutputVtk::setup(int)
{
  if (needs_fluid()) require_fields();
  if (times_.begin_run(nevery)) write_frame();
}

void FixOutputVtk::end_of_step() { write_frame(); }

void FixOutputVtk::write_restart(FILE *fp) { times_.write_restart(fp); }

void FixOutputVtk::restart(char *buffer) { times_.restart(buffer); }

void FixOutputVtk::write_frame()
{
  if (!times_.take_step()) return;
  swellflow::OutputFrame frame;
  frame.step = update->ntimestep;
  frame.time = times_.time();
  frame.own_from = times_.own_from();
  if (needs_fluid()) frame.fluid = fluid();
  if (options_.centres) frame.measures = measure_objects(lmp, groupbit);
  if (draws_objects()) {
    collect_objects(frame);
    collect_points(frame);
  }
  try {
    partner_->write(frame);
  } catch (const std::runtime_error &failure) {
    error->fix_error(FLERR, this, failure.what());
  }
}

void FixOutputVtk::collect_objects(swellflow::OutputFrame &frame) const
{
  const FixObjects *all = find_objects(lmp);
  for (const auto &object : all->objects())
    if (all->owns(object) && (atom->mask[object.hub] & groupbit)) frame.objects.push_back(object);
}

/// Ghosts' velocities are those of the middle of the step, and their forces are not summed up: ask their owners.
void FixOutputVtk::collect_points(swellflow::OutputFrame &frame) const
{
  const int n_all = atom->nlocal + atom->nghost;
  for (auto [values, whence] : {std::pair(&frame.velocity, atom->v), std::pair(&frame.force, atom->f)}) {
    values->resize(3 * n_all);
    for (int i = 0; i < atom->nlocal; i++) std::copy_n(whence[i], 3, values->data() + 3 * i);
    find_objects(lmp)->send_to_ghosts(values->data(), 3);
  }
}
