#include "object_list.h"

#include "objects/csv_table.h"
#include "options.h"

namespace swellflow {

namespace {

const Range cds_range = Range::above_to(0.0, 0.5);  // a sphere on the outline must not be wider than its object

/// The keywords that say what an object is. Those that a file may give for each object are optional there.
void read_disk(Arguments &line, NewObject &object, const CsvTable *table = nullptr)
{
  int share = static_cast<int>(object.disk.share);
  Options options(line.place());
  options.number("diameter", object.disk.diameter, Range::positive(), "length", "natural diameter");
  if (!table || !table->has("diameter")) options.required();
  options.number("density", object.disk.density, Range::positive(), "mass per volume", "density of the object");
  if (!table || !table->has("density")) options.required();
  options.integer("points", object.disk.ring_points, Range::at_least(3), "mass points on the ring");
  options.number("cds", object.disk.cds_ratio, cds_range, "of the diameter", "radius of the contact detection spheres");
  options.integer("type", object.type, Range::at_least(1), "atom type of all points");
  options.choice("mass", share, {"hub_half", "equal"}, "how the mass is shared among hub and ring");
  options.parse(line);
  object.disk.share = static_cast<MassShare>(share);
}

std::vector<NewObject> read_one(int narg, char **arg)
{
  Arguments line("create_objects disk", narg, arg);
  NewObject object;
  object.place = line.place();
  object.centre.x() = line.number("x");
  object.centre.y() = line.number("y");
  read_disk(line, object);
  return {object};
}

/// Rows along x, from the first object, which is centred at `origin`.
std::vector<NewObject> read_lattice(int narg, char **arg)
{
  Arguments line("create_objects lattice", narg, arg);
  const int nx = line.integer("objects along x", Range::at_least(1)), ny = line.integer("objects along y", Range::at_least(1));
  const auto expect = [&](const char *word) {
    const std::string given = line.word(word);
    if (given != word) line.fail(std::string("here must stand '") + word + "', but there is '" + given + "': see the page of create_objects");
  };
  expect("origin");
  Vector2 origin, spacing;
  origin.x() = line.number("origin");
  origin.y() = line.number("origin");
  expect("spacing");
  spacing.x() = line.number("spacing", Range::positive(), "length");
  spacing.y() = line.next_is_number() ? line.number("spacing", Range::positive(), "length") : spacing.x();
  expect("disk");
  NewObject object;
  object.place = line.place();
  read_disk(line, object);

  std::vector<NewObject> all;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      object.centre = origin + Vector2(i * spacing.x(), j * spacing.y());
      all.push_back(object);
    }
  return all;
}

double checked(const CsvTable &table, const CsvTable::Row &row, const std::string &column, double otherwise, const Range &range)
{
  const double value = table.value(row, column).value_or(otherwise);
  if (!range.holds(value))
    throw OptionError(table.place(row) + ": '" + column + "' must be a number " + range.words() + ", but is '" + shown(value) + "': change it");
  return value;
}

int checked_integer(const CsvTable &table, const CsvTable::Row &row, const std::string &column, int otherwise, const Range &range)
{
  const double value = checked(table, row, column, otherwise, range);
  if (value != static_cast<int>(value))
    throw OptionError(table.place(row) + ": '" + column + "' must be a whole number, but is '" + shown(value) + "': change it");
  return static_cast<int>(value);
}

std::vector<NewObject> read_table(int narg, char **arg, const std::function<std::string(const std::string &)> &read_text)
{
  Arguments line("create_objects file", narg, arg);
  const std::string file = line.word("file");
  const CsvTable table(file, read_text(file), {"x", "y", "diameter", "points", "density", "cds", "type"});
  for (const char *column : {"x", "y"})
    if (!table.has(column)) throw OptionError(file + " line 1: column '" + column + "' must be there, but is not: add it");
  NewObject pattern;
  read_disk(line, pattern, &table);

  std::vector<NewObject> all;
  for (const CsvTable::Row &row : table.rows()) {
    NewObject object = pattern;
    object.place = table.place(row);
    object.centre = {checked(table, row, "x", 0.0, Range::any()), checked(table, row, "y", 0.0, Range::any())};
    object.disk.diameter = checked(table, row, "diameter", pattern.disk.diameter, Range::positive());
    object.disk.density = checked(table, row, "density", pattern.disk.density, Range::positive());
    object.disk.cds_ratio = checked(table, row, "cds", pattern.disk.cds_ratio, cds_range);
    object.disk.ring_points = checked_integer(table, row, "points", pattern.disk.ring_points, Range::at_least(3));
    object.type = checked_integer(table, row, "type", pattern.type, Range::at_least(1));
    all.push_back(object);
  }
  return all;
}

}  // namespace

std::vector<NewObject> read_object_list(int narg, char **arg, const std::function<std::string(const std::string &)> &read_text)
{
  Arguments line("create_objects", std::min(narg, 1), arg);
  switch (line.choice("form", {"disk", "lattice", "file"})) {
    case 0: return read_one(narg - 1, arg + 1);
    case 1: return read_lattice(narg - 1, arg + 1);
    default: return read_table(narg - 1, arg + 1, read_text);
  }
}

}  // namespace swellflow
