// Makes LIGGGHTS' restart files hold all that a run needs to go on to the last bit, and sees to it that they are complete. Made with the box, in every scene.
#pragma once

#include <string>
#include <vector>

#include "checkpoint_file.h"
#include "fix.h"
#include "stop_request.h"

namespace LAMMPS_NS {

class FixPropertyAtom;
struct RestartLine;

class FixCheckpoint : public Fix {
 public:
  static constexpr const char *ID = "checkpoint";

  FixCheckpoint(class LAMMPS *, int, char **);
  ~FixCheckpoint() override;

  int setmask() override;
  void init() override;
  void setup(int) override;
  void pre_initial_integrate() override;
  void end_of_step() override;
  void write_restart(FILE *) override;
  void write_restart_file(char *) override;
  void restart(char *) override;
  // Forces and torques, which LIGGGHTS makes anew: out of the atoms, and back into a column that is there only in a run that goes on.
  int size_restart(int) override { return 1 + N_COLUMNS; }
  int maxsize_restart() override { return size_restart(0); }
  int pack_restart(int i, double *values) override;
  void unpack_restart(int i, int nth) override;

  /// The restart file that the scene comes from, until the first run.
  void set_source(const swellflow::CheckpointFile &source)
  {
    source_ = source;
    read_from_ = source.name;
  }
  const swellflow::CheckpointFile &source() const { return source_; }
  /// Whether the run that begins goes on within another, which wrote the file: what a set-up would work out anew is as it was, then.
  bool continues() const;
  /// Then: those that the file has, after all others have been summed up.
  void restore_forces();
  /// Around LIGGGHTS' own write_restart.
  void begin_command(const std::string &file)
  {
    in_command_ = true;
    require_writable(file);
  }
  void end_command() { in_command_ = false; }
  void require_whole_fluid_step(const std::string &place) const;
  /// Empty: none was written.
  const std::string &last_good() const { return last_good_; }
  /// That, or the one that the scene comes from; empty: neither.
  const std::string &to_go_on_from() const { return last_good_.empty() ? read_from_ : last_good_; }

 private:
  /// What LIGGGHTS' own restart data leave out.
  struct State {
    double in_run, step, time, time_step, next_sort;
  };
  static constexpr const char *KEPT = "checkpoint_force";  // name of that column
  enum Column { FORCE_X, FORCE_Y, FORCE_Z, TORQUE_X, TORQUE_Y, TORQUE_Z, N_COLUMNS };

  void add_column();
  FixPropertyAtom &kept_forces();
  void mark_names();
  void require_fitting_intervals() const;
  void warn_of_end_within_fluid_step() const;
  void require_writable(const RestartLine &line, bigint step);
  void require_writable(const std::string &file);
  void require_all_atoms(const std::string &file, const std::vector<int> &sizes) const;
  [[noreturn]] void fail(const std::string &file, const std::string &reason);

  swellflow::CheckpointFile source_;
  State state_{};
  bool restored_ = false, in_command_ = false;
  int sort_every_ = 0;
  std::string last_good_, read_from_;
  StopRequest stop_;
};

/// Null before there is a box.
FixCheckpoint *find_checkpoint(class LAMMPS *);
/// Made when it is missing. Collective.
FixCheckpoint *make_checkpoint(class LAMMPS *);

}  // namespace LAMMPS_NS
