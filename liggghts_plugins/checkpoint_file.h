// The frame of a checkpoint: LIGGGHTS' own restart data, then the fluid's, then what shows that nothing is missing or changed.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace swellflow {

/// What is being written bears this behind its name until it is complete.
inline constexpr const char *unfinished = ".writing";
bool is_unfinished(const std::string &file);

struct CheckpointFile {
  std::string name;
  long fluid_begin = 0, fluid_end = 0;  ///< equal: it holds no fluid
  bool checked = false;                 ///< a plain restart file of LIGGGHTS has no checksum
};

/// The end mark with the checksum of all that is in the file, and all of it on the disk. Throws std::runtime_error.
void complete_checkpoint(const std::string &file, long fluid_begin);
/// That a file was renamed is on the disk, too. Throws std::runtime_error.
void sync_folder(const std::string &of_file);
/// Throws std::invalid_argument with the reason when the file cannot be read, is damaged, cut short, or something else.
CheckpointFile checked_checkpoint(const std::string &file);
/// The complete file of the highest step that matches a name with one '*'; `warn` hears of those that are damaged. Throws std::invalid_argument when there is none.
template <class Warn> CheckpointFile newest_checkpoint(const std::string &pattern, const Warn &warn);

/// Steps of the files that match, from the highest on.
std::vector<long> steps_of_files(const std::string &pattern);
/// The pattern with the step in place of its '*'.
std::string with_step(const std::string &pattern, long step);

template <class Warn> CheckpointFile newest_checkpoint(const std::string &pattern, const Warn &warn)
{
  for (const long step : steps_of_files(pattern)) try {
      return checked_checkpoint(with_step(pattern, step));
    } catch (const std::invalid_argument &reason) {
      warn(reason.what());
    }
  throw std::invalid_argument("there must be a complete restart file of the name '" + pattern + "', but there is none: check the name and the folder");
}

}  // namespace swellflow
