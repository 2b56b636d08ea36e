// Places to begin a packing with: by chance, yet everywhere equally dense. Free of LIGGGHTS.
#pragma once

#include "packed_bodies.h"
#include "random_numbers.h"

namespace swellflow {

/// Random sequential addition (Widom, J. Chem. Phys. 44, 3888 (1966)) of discs that stand for the bodies, made small enough for it. Points that know nothing of each
/// other would leave regions that differ by the root of their number, and bodies that push each other apart do not even that out. Throws std::invalid_argument when the
/// room has no place inside.
std::vector<Vector2> random_places(const PackingTask &task, RandomNumbers &random);

}  // namespace swellflow
