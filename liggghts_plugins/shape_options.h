// The words of a create_objects line that say what its objects are, whatever their number and places.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "object_list.h"
#include "objects/csv_table.h"
#include "objects/size_distribution.h"
#include "options.h"

namespace swellflow {

class ShapeOptions {
public:
  enum Kind { DISK, ELLIPSE, OUTLINE };
  static const std::vector<std::string> names;  ///< by Kind

  /// An outline's word is followed by its file, which is read.
  ShapeOptions(Kind kind, Arguments &line, const ObjectScene &scene);

  /// The keywords, and those that a form declares on top. Those that a table may give for each object are optional when it has their column.
  void read(Arguments &line, const CsvTable *table = nullptr, const std::function<void(Options &)> &declare_more = {});

  /// An object as the keywords say; what a row of a table says instead is told by `row`.
  struct Row {
    std::optional<double> diameter, density, angle, cds, reach;
    std::optional<int> points, type;
  };
  NewObject object(const std::string &place, const Row &row);
  double size_factor(std::size_t number) const { return sizes_.factor(number); }

private:
  void read_sizes(Arguments &line);
  std::shared_ptr<const Shape> shape(const ShapeRequest &request, const std::string &place);

  Kind kind_;
  ShapeRequest request_;
  double diameter_ = 0.0, axes_[2] = {0.0, 0.0};
  double density_ = 0.0, angle_ = 0.0;
  int type_ = 1;
  SizeDistribution sizes_;
  std::map<std::tuple<int, double, double>, std::shared_ptr<const Shape>> made_;  // of the objects of a table, many are alike
};

/// The ranges of what a table may give for each object, too.
Range cds_range();
Range reach_range();
Range points_range(ShapeOptions::Kind kind);

}  // namespace swellflow
