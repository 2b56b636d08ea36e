// What fix output/vtk hands to whoever writes the files. The coupling implements it with VTK's XML writers.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fluid_partner.h"
#include "objects/measures.h"

namespace swellflow {

struct OutputOptions {
  std::string folder = "post";
  std::vector<std::string> fields;  ///< names of FluidPartner::fields()
  bool outline = false, points = false, cds = false, centres = false;
  std::string units = "si";         ///< LIGGGHTS' units style: it names the units in the files
};

/// One moment of the run. Every object appears on one rank only: that of its hub.
struct OutputFrame {
  long step = 0;
  double time = 0.0;
  double own_from = 0.0;                 ///< frames that an earlier run wrote before this time stay in the series
  std::vector<ObjectPoints> objects;     ///< to be written by this rank
  std::vector<double> velocity, force;   ///< three values a point, own points and then ghosts, all at `time`
  std::vector<ObjectMeasures> measures;  ///< of the objects to be written by this rank, when OutputOptions::centres
  const FluidPartner *fluid = nullptr;   ///< null in a scene without one
};

class OutputPartner {
public:
  virtual ~OutputPartner() = default;
  /// Collective; throws std::runtime_error on every rank.
  virtual void write(const OutputFrame &frame) = 0;
};

/// Prepares the folder. Collective; throws std::runtime_error on every rank with rule, value, remedy.
using OutputPartnerFactory = std::function<std::unique_ptr<OutputPartner>(void *lammps, const OutputOptions &)>;

}  // namespace swellflow
