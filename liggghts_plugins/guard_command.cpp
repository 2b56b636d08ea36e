// The command `guard`: what becomes of limits that are broken.
#include "comm.h"
#include "domain.h"
#include "fix_guard.h"
#include "guard.h"
#include "modify.h"
#include "options.h"
#include "register_styles.h"

using namespace LAMMPS_NS;

namespace swellflow {

void set_guard(LAMMPS *lmp, int narg, char **arg)
{
  or_stop(lmp, [&] {
    Arguments line("guard", narg, arg);
    const auto mode = static_cast<GuardMode>(line.choice("mode", {"refuse", "warn", "off"}));
    Options(line.place()).parse(line);
    guard_mode(lmp) = mode;
  });
  if (FixGuard *guard = find_guard(lmp)) guard->set_mode(guard_mode(lmp));
}

void make_guard(LAMMPS *lmp)
{
  if (!find_guard(lmp)) {
    const char *words[] = {FixGuard::ID, "all", "guard"};
    lmp->modify->add_fix(3, const_cast<char **>(words));
  }
  find_guard(lmp)->set_mode(guard_mode(lmp));
}

}  // namespace swellflow
