// Puts our fix styles and input commands beside LIGGGHTS' own, at run time, and keeps them there after `clear`.
#pragma once

#include <string>
#include <vector>

#include "fluid_partner.h"
#include "output_partner.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace swellflow {

/// The version whose private style maps we know.
inline constexpr const char *supported_liggghts = "3.8.0";

/// What the styles need from outside; the program hands it in, the scripts' commands hand it on.
struct Factories {
  FluidPartnerFactory fluid;
  OutputPartnerFactory output;
};

/// Afterwards scripts know our styles. To be called before the first line is read.
/// Throws std::runtime_error, on every rank, when this is not the LIGGGHTS that we know.
void register_styles(LAMMPS_NS::LAMMPS *lmp, const Factories &factories);

/// Names for -help; internal styles are left out.
std::vector<std::string> our_fix_styles();
std::vector<std::string> our_commands();

}  // namespace swellflow
