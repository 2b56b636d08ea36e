// The forces of a run that goes on from a restart file.
#include <algorithm>

#include "atom.h"
#include "error.h"
#include "fix_checkpoint.h"
#include "fix_property_atom.h"
#include "modify.h"

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   Forces are made with the velocities within a step. When a run begins
   they are made anew, with others: to go on they have to be as they were.
------------------------------------------------------------------------- */

void FixCheckpoint::restore_forces()
{
  const FixPropertyAtom &forces = kept_forces();
  for (int i = 0; i < atom->nlocal; i++) {
    const double *kept = forces.array_atom[i];
    for (int d = 0; d < 3; d++) atom->f[i][d] = kept[FORCE_X + d];
    for (int d = 0; d < 3 && atom->torque_flag; d++) atom->torque[i][d] = kept[TORQUE_X + d];
  }
}

void FixCheckpoint::add_column()
{
  const char *start[] = {KEPT, "all", "property/atom", KEPT, "vector", "no", "no", "no"};
  std::vector<char *> arguments;
  for (const char *word : start) arguments.push_back(const_cast<char *>(word));
  arguments.resize(arguments.size() + N_COLUMNS, const_cast<char *>("0"));
  modify->add_fix(arguments.size(), arguments.data());
  kept_forces().recent_restart = 1;  // else LIGGGHTS sets it to zero when the run begins
}

FixPropertyAtom &FixCheckpoint::kept_forces()
{
  const int found = modify->find_fix(KEPT);
  if (found < 0) error->fix_error(FLERR, this, "fix 'checkpoint_force' holds what the run goes on with, but is gone: remove 'unfix checkpoint_force'");
  return static_cast<FixPropertyAtom &>(*modify->fix[found]);
}

int FixCheckpoint::pack_restart(int i, double *values)
{
  *values++ = size_restart(i);
  for (int d = 0; d < 3; d++) values[FORCE_X + d] = atom->f[i][d];
  for (int d = 0; d < 3; d++) values[TORQUE_X + d] = atom->torque_flag ? atom->torque[i][d] : 0.0;
  return size_restart(i);
}

/// `nth` of the fixes that have values in the atom's row, each led by how many.
void FixCheckpoint::unpack_restart(int i, int nth)
{
  if (state_.in_run == 0.0) return;
  const double *values = atom->extra[i];
  for (int k = 0; k < nth; k++) values += static_cast<int>(*values);
  std::copy_n(values + 1, +N_COLUMNS, kept_forces().array_atom[i]);
}
