// Bodies at random places, without overlap, as dense as is asked for. Free of LIGGGHTS.
#pragma once

#include "packed_bodies.h"

namespace swellflow {

struct Packing {
  std::vector<Placement> placements;  ///< with centres in the box where it is periodic
  double scale = 1.0;                 ///< by which sizes were multiplied: 1, or below when they do not fit
};

/// Depends on the task alone. Bodies start at random places, push each other apart (as O'Hern, Silbert, Liu and Nagel, Phys. Rev. E 68, 011306 (2003), who find that
/// discs jam at 0.84) and are then shaken. What does not fit so grows from a smaller size, by turns of growing and shaking, in the manner of Lubachevsky and Stillinger,
/// J. Stat. Phys. 60, 561 (1990). Throws std::invalid_argument when the room has no place inside.
Packing pack_at_random(const PackingTask &task);

}  // namespace swellflow
