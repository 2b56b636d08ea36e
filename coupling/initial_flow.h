// The flow before the first step, as the script describes it.
#pragma once

#include "fluid/flow_solver.h"
#include "liggghts_plugins/fluid_partner.h"

namespace swellflow {

/// The same velocity everywhere, or linear between two walls. Collective.
template <int Dim> void start(FlowSolver<Dim> &flow, const Boundaries<Dim> &boundaries, const FluidOptions &options);

extern template void start(FlowSolver<2> &, const Boundaries<2> &, const FluidOptions &);

}  // namespace swellflow
