#include "per_atom_values.h"

#include <vector>

#include "fix_property_atom.h"
#include "modify.h"

using namespace LAMMPS_NS;

FixPropertyAtom *LAMMPS_NS::add_per_atom_values(LAMMPS *lmp, const std::string &name, int columns, bool on_ghosts)
{
  std::vector<const char *> words = {name.c_str(), "all", "property/atom", name.c_str(), "vector", "yes", on_ghosts ? "yes" : "no", "no"};
  words.resize(words.size() + columns, "0");
  std::vector<char *> arguments;
  for (const char *word : words) arguments.push_back(const_cast<char *>(word));
  lmp->modify->add_fix(arguments.size(), arguments.data());
  return static_cast<FixPropertyAtom *>(lmp->modify->fix[lmp->modify->find_fix(name.c_str())]);
}
