// The per-atom vectors through which a fluid and LIGGGHTS' points meet: fix fluid/ib makes them, the coupling fills them, integrators read them.
#pragma once

namespace swellflow {

/// The law that gives the fluid's force on a point over the coming DEM steps, force = A - KAPPA v, with KAPPA [mass / time] >= 0. Ghosts have it too.
struct FluidLaw {
  static constexpr const char *NAME = "fluid_law";
  enum Column { KAPPA, A_X, A_Y, A_Z, N_COLUMNS };
};

/// The impulse that a point truly received from that law since the fluid step began.
struct FluidImpulse {
  static constexpr const char *NAME = "fluid_impulse";
  enum Column { RECEIVED_X, RECEIVED_Y, RECEIVED_Z, N_COLUMNS };
};

/// By how much the velocity of a point at the end of a DEM step is ahead of what it received so far (FixObjectIntegrator); and what acted on it beside the fluid when the fluid step
/// began: weight, contacts, springs. Ghosts have it too.
struct FluidAhead {
  static constexpr const char *NAME = "fluid_ahead";
  enum Column { AHEAD_X, AHEAD_Y, KNOWS_AHEAD, OUTER_X, OUTER_Y, N_COLUMNS };
};

/// The force that a point's markers gave to the fluid in the last fluid step and that is carried into the next; and of the impulse behind it the part that came
/// after the points had moved (forcing schemes other than direct), which they are still to receive. Ghosts have it too.
struct FluidCarried {
  static constexpr const char *NAME = "fluid_carried";
  enum Column { FORCE_X, FORCE_Y, FORCE_Z, OWED_X, OWED_Y, OWED_Z, N_COLUMNS };
};

/// While a fluid step is under way.
struct FluidHome {
  static constexpr const char *NAME = "fluid_home";
  enum Column {
    HAS_MARKERS,       // 1 when the step has markers of this point …
    HOME_RANK,         // … which this rank keeps account of …
    HOME_SLOT,         // … in this place
    INNER_FORCE_X,     // of the fluid inside, its inertia, its weight and its pressure, in the mean over the step: part of the law
    INNER_FORCE_Y,
    PRESSURE_X,        // of that the pressure as it is (InnerPressure) …
    PRESSURE_Y,
    PRESSED,           // … its share f, 0: there is none …
    AREA_CHANGE,       // … by which the fluid inside may follow the outline in the step, relative …
    AREA_PER_POINTS,   // … and the area of the outline over that inside the ring points
    N_COLUMNS
  };
};

/// What else must migrate with a point between fluid steps.
struct FluidState {
  static constexpr const char *NAME = "fluid_state";
  enum Column {
    // Up to CONTACT_STEPS all points of an object have the same.
    KNOWS_BEFORE,      // whether the next four are known; 1 in the first fluid step, 2 afterwards
    VELOCITY_X,        // of the object when the last fluid step began
    VELOCITY_Y,
    SPIN,
    SWELLING,          // natural swelling ratio of the object then
    DUE_X,             // change of velocity and spin for which the inertia of the fluid inside has not been returned yet
    DUE_Y,
    DUE_SPIN,
    RETURNED_X,        // acceleration for which it is returned in the present fluid step
    RETURNED_Y,
    RETURNED_SPIN,
    CONTACT_X,         // force and torque of its contacts, running mean
    CONTACT_Y,
    CONTACT_TURN,
    CONTACT_STEPS,     // for how many fluid steps on end it has not been much less
    INNER_AREA,        // of the hub of an object that inflates: what fluid there is inside; 0: not known yet
    FILLED,            // of the same: 1 while markers fill it
    AREA_INSIDE,       // of the fluid inside a heavy ring (InnerPressure) when the fluid step began; 0: not known
    AREA_BEYOND,       // by which the outline's was more when its pressure was found last, relative
    N_COLUMNS
  };
};

/// All of them.
constexpr const char *fluid_column_names[] = {FluidLaw::NAME, FluidImpulse::NAME, FluidAhead::NAME, FluidCarried::NAME, FluidHome::NAME, FluidState::NAME};

}  // namespace swellflow
