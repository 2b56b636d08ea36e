#include "outline_file.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "csv_table.h"

namespace swellflow {

namespace {

void require_different_points(const CsvTable &table, const Polygon &outline)
{
  std::vector<std::size_t> order(outline.size());
  std::iota(order.begin(), order.end(), 0);
  const auto lower = [&](std::size_t a, std::size_t b) {
    return std::lexicographical_compare(outline[a].begin(), outline[a].end(), outline[b].begin(), outline[b].end());
  };
  std::stable_sort(order.begin(), order.end(), lower);
  for (std::size_t n = 1; n < order.size(); ++n)
    if (outline[order[n - 1]] == outline[order[n]])
      throw std::invalid_argument(table.place(table.rows()[order[n]]) + ": an outline must have each point once, but this is that of line " +
                                  std::to_string(table.rows()[order[n - 1]].line) + ": leave it out; the last point is joined to the first without it");
}

}  // namespace

Polygon read_outline(const std::string &file, const std::string &text)
{
  const CsvTable table(file, text, {"x", "y"});
  for (const char *column : {"x", "y"})
    if (!table.has(column)) throw std::invalid_argument(file + ": an outline must have the columns x and y, but '" + column + "' is missing: add it");
  Polygon outline;
  for (const CsvTable::Row &row : table.rows()) outline.emplace_back(*table.value(row, "x"), *table.value(row, "y"));
  if (outline.size() < 3)
    throw std::invalid_argument(table.place(table.rows().back()) + ": an outline must have at least 3 points, but ends here after " +
                                std::to_string(outline.size()) + ": add some");
  require_different_points(table, outline);
  if (const auto edges = self_intersection(outline))
    throw std::invalid_argument(table.place(table.rows()[edges->second]) + ": an outline must not cross or touch itself, but the side that begins here meets the one "
                                "that begins at line " + std::to_string(table.rows()[edges->first].line) + ": correct the points");
  return outline;
}

}  // namespace swellflow
