#include "sort_bins.h"

#include "atom.h"

namespace LAMMPS_NS {

namespace {

// Atom::userbinsize is private, and what was asked for cannot be found out in another way. Access is not checked in an explicit instantiation, as in register_styles.cpp.
double &bin_size_of(Atom &);
template <double Atom::*Member>
struct BinSizeAccess {
  friend double &bin_size_of(Atom &atom) { return atom.*Member; }
};
template struct BinSizeAccess<&Atom::userbinsize>;

}  // namespace

double &sort_bin_size(Atom &atom) { return bin_size_of(atom); }

}  // namespace LAMMPS_NS
