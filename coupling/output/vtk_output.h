// Frames for ParaView: what fix output/vtk asks for, written with VTK's XML writers.
#pragma once

#include <memory>

#include "liggghts_plugins/output_partner.h"

namespace swellflow {

/// `lammps` is the library's handle. Collective; throws std::runtime_error on every rank with rule, value, remedy.
std::unique_ptr<OutputPartner> make_vtk_output(void *lammps, const OutputOptions &options);

}  // namespace swellflow
