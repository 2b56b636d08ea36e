// Bodies that do not overlap are moved at random, so that chance alone says where they are. Free of LIGGGHTS.
#pragma once

#include "packed_bodies.h"
#include "random_numbers.h"

namespace swellflow {

/// Hard bodies by the rule of Metropolis, Rosenbluth, Rosenbluth, Teller and Teller, J. Chem. Phys. 21, 1087 (1953): in each sweep each is moved (and turned) a little, if it
/// then overlaps nothing.
void shake(PackedBodies &bodies, int sweeps, RandomNumbers &random);

}  // namespace swellflow
