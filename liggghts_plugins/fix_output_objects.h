// Measures of each object over time, as comma-separated values in a file, and sums and means over the objects as values of the fix.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "fix.h"
#include "objects/measure_file.h"
#include "output_times.h"

namespace LAMMPS_NS {

class FixOutputObjects : public Fix {
 public:
  FixOutputObjects(class LAMMPS *, int, char **);

  int setmask() override;
  void post_create() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double compute_scalar() override;
  double compute_vector(int) override;

 private:
  static constexpr int N_VALUES = 18;

  bool has_file() const { return !file_name_.empty(); }
  void open_file();
  void require_own_file();
  void require_chosen_objects();
  void fail(const std::string &message);
  std::vector<swellflow::ObjectMeasures> chosen_objects() const;
  void write_lines();
  const std::array<double, N_VALUES> &values();

  std::string file_name_;                          // empty: none
  std::vector<int> chosen_;                        // ids; empty: all of the group
  std::unique_ptr<swellflow::MeasureFile> file_;   // on rank 0
  bool begun_;                                     // whether lines of an earlier run that are to be replaced have gone
  OutputTimes times_;
  std::array<double, N_VALUES> values_;
  bigint values_step_;  // of values_; -1: none
};

}  // namespace LAMMPS_NS
