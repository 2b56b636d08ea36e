// The list of frames with their times that ParaView opens (.pvd). It is complete at every moment, whatever kills the run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace swellflow {

struct PvdEntry {
  double time;
  int part;          ///< a .pvd may hold several data sets a time
  std::string name;  ///< of the part
  std::string file;  ///< relative to the .pvd
};

class PvdCollection {
public:
  /// Takes over what an earlier run listed before `now`; later entries are about to be replaced. One rank only.
  PvdCollection(std::filesystem::path file, double now);
  void add(const PvdEntry &entry);
  /// A new file takes the old one's place in one move, so a reader or a crash never meets half of it.
  void write() const;

private:
  std::filesystem::path file_;
  std::vector<PvdEntry> entries_;
};

}  // namespace swellflow
