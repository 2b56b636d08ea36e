#include "csv_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace swellflow {

namespace {

constexpr double largest = 1e100;  ///< its square is a number, too
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";  // spreadsheets put it before what they save as UTF-8

std::string trimmed(const std::string &text)
{
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> cells_of(const std::string &line)
{
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(trimmed(cell));
  if (line.back() == ',') cells.emplace_back();
  return cells;
}

[[noreturn]] void fail(const std::string &file, int line, const std::string &message)
{
  throw std::invalid_argument(file + " line " + std::to_string(line) + ": " + message);
}

}  // namespace

CsvTable::CsvTable(const std::string &file, const std::string &text, const std::vector<std::string> &known_columns) : file_(file)
{
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (number == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    if (columns_.empty())
      read_header(number, cells_of(line), known_columns);
    else
      read_row(number, cells_of(line));
  }
  if (rows_.empty()) fail(file, number, "the file must hold a line of names and at least one line of numbers, but ends here: add them");
}

void CsvTable::read_header(int line, const std::vector<std::string> &cells, const std::vector<std::string> &known_columns)
{
  std::string known;
  for (const std::string &column : known_columns) known += (known.empty() ? "" : ", ") + column;
  for (const std::string &title : cells) {
    const std::string cell = trimmed(title.substr(0, title.find('[')));
    if (!known_columns.empty() && std::find(known_columns.begin(), known_columns.end(), cell) == known_columns.end())
      fail(file_, line, "the first line must name the columns, but has '" + cell + "': known are " + known);
    if (has(cell)) fail(file_, line, "column '" + cell + "' is there twice: keep one of them");
    columns_.push_back(cell);
  }
}

void CsvTable::read_row(int line, const std::vector<std::string> &cells)
{
  if (cells.size() != columns_.size())
    fail(file_, line, "there must be " + std::to_string(columns_.size()) + " numbers, one for each column, but there are " +
                          std::to_string(cells.size()) + ": correct the line");
  Row row{.line = line, .values = {}};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    char *end = nullptr;
    const double value = std::strtod(cells[k].c_str(), &end);
    if (cells[k].empty() || end != cells[k].data() + cells[k].size() || !(std::abs(value) <= largest))  // a zero byte may stand within
      fail(file_, line, "'" + columns_[k] + "' must be a number, but is '" + cells[k] + "': change it");
    row.values.push_back(value);
  }
  rows_.push_back(row);
}

std::optional<std::size_t> CsvTable::position(const std::string &column) const
{
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) return std::nullopt;
  return found - columns_.begin();
}

std::optional<double> CsvTable::value(const Row &row, const std::string &column) const
{
  const auto at = position(column);
  if (!at) return std::nullopt;
  return row.values[*at];
}

}  // namespace swellflow
