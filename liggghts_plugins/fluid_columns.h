// The per-atom vectors through which a fluid and LIGGGHTS' points meet: fix fluid/ib makes them, the coupling fills them, integrators read them.
#pragma once

namespace swellflow {

/// The law that gives the fluid's force on a point over the coming DEM steps, force = A - KAPPA v, with KAPPA [mass / time] >= 0.
struct FluidLaw {
  static constexpr const char *NAME = "fluid_law";
  enum Column { KAPPA, A_X, A_Y, A_Z, N_COLUMNS };
};

/// The impulse that a point truly received from that law since the fluid step began: x, y, z.
struct FluidImpulse {
  static constexpr const char *NAME = "fluid_impulse";
  static constexpr int N_COLUMNS = 3;
};

/// The force that a point's markers gave to the fluid in the last fluid step and that is carried into the next; and of the impulse behind it the part that came
/// after the points had moved (forcing schemes other than direct), which they are still to receive. Ghosts have it too.
struct FluidCarried {
  static constexpr const char *NAME = "fluid_carried";
  enum Column { FORCE_X, FORCE_Y, FORCE_Z, OWED_X, OWED_Y, OWED_Z, N_COLUMNS };
};

/// What else must migrate with a point between fluid steps.
struct FluidState {
  static constexpr const char *NAME = "fluid_state";
  enum Column {
    HAS_MARKERS,       // 1 while a fluid step is under way that has markers of this point …
    HOME_RANK,         // … which this rank keeps account of …
    HOME_SLOT,         // … in this place
    KNOWS_BEFORE,      // 1 once the next four are known
    RING_VELOCITY_X,   // mean over the object's ring when the last fluid step began
    RING_VELOCITY_Y,
    RING_SPIN,
    SWELLING,          // natural swelling ratio of the object then
    ACCELERATION_X,    // of the ring, smoothed over fluid steps
    ACCELERATION_Y,
    SPIN_ACCELERATION,
    BODY_FORCE_X,      // inertia of the fluid inside, and buoyancy
    BODY_FORCE_Y,
    N_COLUMNS
  };
};

}  // namespace swellflow
