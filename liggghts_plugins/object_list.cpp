#include "object_list.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "random_objects.h"
#include "shape_options.h"

namespace swellflow {

namespace {

using Objects = std::vector<NewObject>;

Objects read_one(ShapeOptions::Kind kind, Arguments &line, const ObjectScene &scene)
{
  ShapeOptions shape(kind, line, scene);
  const double x = line.number("x"), y = line.number("y");
  shape.read(line);
  NewObject object = shape.object(line.place(), {});
  object.centre = {x, y};
  object.diameter *= shape.size_factor(0);
  return {object};
}

/// Rows along x, from the first object, which is centred at `origin`.
Objects read_lattice(Arguments &line, const ObjectScene &scene)
{
  const int nx = line.integer("objects along x", Range::at_least(1)), ny = line.integer("objects along y", Range::at_least(1));
  const double number = static_cast<double>(nx) * ny;
  if (number > most_objects) line.fail("there must be at most 1e7 objects, but " + std::to_string(nx) + " x " + std::to_string(ny) + " are asked for: ask for fewer");
  Vector2 origin, spacing;
  line.expect("origin");
  origin.x() = line.number("origin");
  origin.y() = line.number("origin");
  line.expect("spacing");
  spacing.x() = line.number("spacing", Range::positive(), "length");
  spacing.y() = line.next_is_number() ? line.number("spacing", Range::positive(), "length") : spacing.x();
  ShapeOptions shape(static_cast<ShapeOptions::Kind>(line.choice("shape", ShapeOptions::names)), line, scene);
  shape.read(line);
  const NewObject pattern = shape.object(line.place(), {});
  scene.require_room(line.place(), number * (pattern.shape->ring.size() + 1.0));

  Objects all;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      all.push_back(pattern);
      all.back().centre = origin + Vector2(i * spacing.x(), j * spacing.y());
      all.back().diameter *= shape.size_factor(all.size() - 1);
    }
  return all;
}

std::optional<double> checked(const CsvTable &table, const CsvTable::Row &row, const std::string &column, const Range &range)
{
  const std::optional<double> value = table.value(row, column);
  if (value && !range.holds(*value))
    throw OptionError(table.place(row) + ": '" + column + "' must be a number " + range.words() + magnitude_words(*value) + ", but is '" + shown(*value) + "': change it");
  return value;
}

std::optional<int> checked_integer(const CsvTable &table, const CsvTable::Row &row, const std::string &column, const Range &range)
{
  const std::optional<double> value = checked(table, row, column, range);
  if (!value) return std::nullopt;
  if (std::abs(*value) >= 2147483648.0 || *value != std::floor(*value))
    throw OptionError(table.place(row) + ": '" + column + "' must be a whole number, but is '" + shown(*value) + "': change it");
  return static_cast<int>(*value);
}

/// The last of the measurements in a file of fix output/objects, as a table.
CsvTable last_measurement(const CsvTable &measured, const PlaneBox &box)
{
  constexpr double degree = std::numbers::pi / 180.0;
  std::vector<CsvTable::Row> rows;
  for (const CsvTable::Row &row : measured.rows()) {
    if (*measured.value(row, "step") != *measured.value(measured.rows().back(), "step")) continue;
    const Vector2 x = box.wrapped({*measured.value(row, "centroid_x"), *measured.value(row, "centroid_y")});
    rows.push_back({row.line, {x.x(), x.y(), *measured.value(row, "diameter_of_area"), *measured.value(row, "rotation") / degree}});
  }
  return CsvTable(measured.file(), {"x", "y", "diameter", "angle"}, rows);
}

CsvTable table_of(const std::string &file, const ObjectScene &scene)
{
  const std::string text = scene.text_of_file(file);
  if (text.rfind("step,time", 0) == 0) {
    const CsvTable measured(file, text, {});
    bool whole = true;
    for (const char *column : {"centroid_x", "centroid_y", "diameter_of_area", "rotation"}) whole = whole && measured.has(column);
    if (whole) return last_measurement(measured, scene.box());
  }
  const CsvTable table(file, text, {"x", "y", "diameter", "points", "density", "cds", "reach", "angle", "type"});
  for (const char *column : {"x", "y"})
    if (!table.has(column)) throw OptionError(file + " line 1: column '" + column + "' must be there, but is not: add it");
  return table;
}

ObjectList read_table(Arguments &line, const ObjectScene &scene)
{
  const std::string file = line.word("file");
  const CsvTable table = table_of(file, scene);
  const auto &names = ShapeOptions::names;
  const bool named = !line.empty() && std::find(names.begin(), names.end(), line.peek()) != names.end();
  const auto kind = named ? static_cast<ShapeOptions::Kind>(line.choice("shape", names)) : ShapeOptions::DISK;
  ShapeOptions shape(kind, line, scene);
  ObjectList list;
  shape.read(line, &table, [&](Options &options) {
    options.number("overlap", list.overlap, Range::not_negative(), "length", "by which outlines may overlap, as pressed ones do");
  });

  Objects &all = list.objects;
  for (const CsvTable::Row &row : table.rows()) {
    const ShapeOptions::Row own{.diameter = checked(table, row, "diameter", Range::positive()),
                                .density = checked(table, row, "density", Range::positive()),
                                .angle = checked(table, row, "angle", Range::any()),
                                .cds = checked(table, row, "cds", cds_range()),
                                .reach = checked(table, row, "reach", reach_range()),
                                .points = checked_integer(table, row, "points", points_range(kind)),
                                .type = checked_integer(table, row, "type", Range::at_least(1))};
    all.push_back(shape.object(table.place(row), own));
    all.back().centre = {*checked(table, row, "x", Range::any()), *checked(table, row, "y", Range::any())};
    all.back().diameter *= shape.size_factor(all.size() - 1);
  }
  return list;
}

}  // namespace

Vector2 NewObject::placed(const Vector2 &in_shape) const
{
  const Vector2 x = diameter * in_shape;
  if (angle == 0.0) return x;
  const double turn = angle * std::numbers::pi / 180.0, c = std::cos(turn), s = std::sin(turn);
  return {c * x.x() - s * x.y(), s * x.x() + c * x.y()};
}

Footprint NewObject::footprint() const
{
  Footprint footprint{{centre, 0.5 * diameter}, {}};
  if (shape->is_round) return footprint;
  footprint.circle.radius = 0.0;
  for (const Vector2 &vertex : shape->outline) {
    footprint.outline.push_back(placed(vertex));
    footprint.circle.radius = std::max(footprint.circle.radius, footprint.outline.back().norm());
  }
  return footprint;
}

ObjectList read_object_list(int narg, char **arg, const ObjectScene &scene)
{
  const std::vector<std::string> forms = {"disk", "ellipse", "outline", "lattice", "random", "file"};
  const int form = Arguments("create_objects", std::min(narg, 1), arg).choice("form", forms);
  Arguments line("create_objects " + forms[form], narg - 1, arg + 1);
  if (forms[form] == "lattice") return {.objects = read_lattice(line, scene)};
  if (forms[form] == "random") return read_random_objects(line, scene);
  if (forms[form] == "file") return read_table(line, scene);
  return {.objects = read_one(static_cast<ShapeOptions::Kind>(form), line, scene)};
}

}  // namespace swellflow
