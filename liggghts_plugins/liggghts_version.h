// What LIGGGHTS calls itself: which one we know, and the text by which restart files tell ours from its own.
#pragma once

namespace LAMMPS_NS {
class Universe;
}

namespace swellflow {

/// The only version whose insides we know.
inline constexpr const char *supported_liggghts = "3.8.0";

/// What LIGGGHTS' version is called in the head of our files; they cannot be complete without an end mark.
inline constexpr const char *version_mark = ", swellflow";

/// Throws std::runtime_error when it is another one.
void check_version(const LAMMPS_NS::Universe &universe);
void mark_version(LAMMPS_NS::Universe &universe);
/// As LIGGGHTS has it.
void unmark_version(LAMMPS_NS::Universe &universe);

}  // namespace swellflow
