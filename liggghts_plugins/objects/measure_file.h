// Measures of objects over time as a file of comma-separated values: a line an object and moment. One rank only; free of LIGGGHTS.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measures.h"

namespace swellflow {

class MeasureFile {
public:
  /// Makes the folder when it is missing, and shows that the file can be written, which is left as it is. Throws std::runtime_error: rule, value, remedy.
  MeasureFile(std::filesystem::path file, const UnitNames &units);

  /// Keeps what an earlier run wrote before `now`; later lines, which are about to be replaced, and half a line at the end go. The new file takes the old one's
  /// place in one move. Throws when the file holds something else.
  void begin(double now) const;
  /// In the order of their ids, complete on disk when it returns.
  void append(long step, double time, std::vector<ObjectMeasures> objects) const;

  std::string header() const;

private:
  [[noreturn]] void fail() const;

  std::filesystem::path file_;
  UnitNames units_;
};

}  // namespace swellflow
