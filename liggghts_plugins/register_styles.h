// Puts our fix styles and input commands beside LIGGGHTS' own, at run time, and keeps them there after `clear`.
#pragma once

#include <string>
#include <vector>

#include "fluid_partner.h"
#include "guard.h"
#include "output_partner.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace swellflow {

/// What the styles need from outside; the program hands it in, the scripts' commands hand it on.
struct Factories {
  FluidPartnerFactory fluid;
  OutputPartnerFactory output;
};

/// Afterwards scripts know our styles. To be called before the first line is read.
/// Throws std::runtime_error, on every rank, when this is not the LIGGGHTS that we know.
void register_styles(LAMMPS_NS::LAMMPS *lmp, const Factories &factories);

/// The command that is being carried out, or was last.
std::string command_of(const LAMMPS_NS::LAMMPS *lmp);

/// What `guard` said last.
GuardMode &guard_mode(LAMMPS_NS::LAMMPS *lmp);

/// Names for -help; internal styles are left out.
std::vector<std::string> our_fix_styles();
std::vector<std::string> our_commands();

}  // namespace swellflow
