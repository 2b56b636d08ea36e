// Bodies that overlap push each other apart until none do. Free of LIGGGHTS.
#pragma once

#include "packed_bodies.h"

namespace swellflow {

/// Minimises the energy of overlaps, half of the sum of their squares. Returns whether none is left; if not, the bodies are jammed.
bool relax_overlaps(PackedBodies &bodies);

}  // namespace swellflow
