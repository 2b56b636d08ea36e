#include "measure_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <type_traits>

namespace swellflow {

namespace {

namespace fs = std::filesystem;

/// As short as it can be read back to the last bit.
std::string text_of(double value)
{
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::string titled(const std::string &name, const std::string &unit)
{
  return unit.empty() || unit == "1" ? name : name + " [" + unit + "]";
}

std::string line_of(const ObjectMeasures &object)
{
  std::string line = std::to_string(object.id);
  const auto add = [&line](double value) { line += "," + text_of(value); };
  for (double x : object.centroid) add(x);
  for_each_measure({}, [&](const char *, const std::string &, auto member) {
    if constexpr (std::is_same_v<decltype(member), ObjectMeasures::Plane ObjectMeasures::*>)
      for (double component : object.*member) add(component);
    else
      add(object.*member);
  });
  return line;
}

/// The time of a line that is complete, or nothing: the file ends where the run was ended.
bool is_before(const std::string &line, long columns, double now)
{
  if (std::count(line.begin(), line.end(), ',') != columns - 1) return false;
  std::istringstream words(line);
  std::string step, time;
  std::getline(words, step, ',');
  std::getline(words, time, ',');
  double value = 0.0;
  const auto read = std::from_chars(time.data(), time.data() + time.size(), value);
  return read.ec == std::errc() && value < now - 1e-12 * std::abs(now);
}

}  // namespace

MeasureFile::MeasureFile(fs::path file, const UnitNames &units) : file_(std::move(file)), units_(units)
{
  std::error_code ignored;
  if (file_.has_parent_path()) fs::create_directories(file_.parent_path(), ignored);
  const bool can_be_replaced = !fs::exists(file_, ignored) || fs::is_regular_file(file_, ignored);
  if (!can_be_replaced || !std::ofstream(file_, std::ios::app)) fail();
}

void MeasureFile::fail() const
{
  throw std::runtime_error("cannot write '" + file_.string() + "': free disk space, change the rights of its folder, or name another file");
}

std::string MeasureFile::header() const
{
  std::string line = "step," + titled("time", units_.time) + ",id";
  const auto add = [&](const std::string &name, const std::string &unit) { line += "," + titled(name, unit); };
  for (const char *name : {"centroid_x", "centroid_y"}) add(name, units_.length);
  for_each_measure(units_, [&](const std::string &name, const std::string &unit, auto member) {
    if constexpr (std::is_same_v<decltype(member), ObjectMeasures::Plane ObjectMeasures::*>)
      add(name + "_x", unit), add(name + "_y", unit);
    else
      add(name, unit);
  });
  return line;
}

void MeasureFile::begin(double now) const
{
  const std::string title = header();
  const long columns = std::count(title.begin(), title.end(), ',') + 1;
  std::ifstream old(file_);
  std::string line;
  if (std::getline(old, line) && line != title)
    throw std::runtime_error("'" + file_.string() + "' must hold measures of objects with the columns of this program, or nothing, but begins with '" +
                             line.substr(0, 40) + "': remove it or name another file");
  const fs::path fresh = file_.string() + ".new";
  std::ofstream out(fresh);
  out << title << '\n';
  while (std::getline(old, line))
    if (!old.eof() && is_before(line, columns, now)) out << line << '\n';
  out.close();
  if (!out) fail();
  fs::rename(fresh, file_);
}

void MeasureFile::append(long step, double time, std::vector<ObjectMeasures> objects) const
{
  std::sort(objects.begin(), objects.end(), [](const ObjectMeasures &a, const ObjectMeasures &b) { return a.id < b.id; });
  std::ofstream out(file_, std::ios::app);
  for (const ObjectMeasures &object : objects) out << step << ',' << text_of(time) << ',' << line_of(object) << '\n';
  out.close();
  if (!out) fail();
}

}  // namespace swellflow
