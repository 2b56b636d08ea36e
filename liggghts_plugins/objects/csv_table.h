// A comma-separated table of numbers under a line of names; free of LIGGGHTS.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace swellflow {

class CsvTable {
public:
  struct Row {
    int line;  ///< in the file, from 1
    std::vector<double> values;
  };

  /// Blank lines and lines that start with # are skipped, and units in brackets behind names. No known columns: any. Throws std::invalid_argument that names file and line.
  CsvTable(const std::string &file, const std::string &text, const std::vector<std::string> &known_columns);

  /// Of rows that were read from a file in another form.
  CsvTable(const std::string &file, const std::vector<std::string> &columns, const std::vector<Row> &rows) : file_(file), columns_(columns), rows_(rows) {}

  const std::string &file() const { return file_; }
  const std::vector<Row> &rows() const { return rows_; }
  bool has(const std::string &column) const { return position(column).has_value(); }
  std::optional<double> value(const Row &row, const std::string &column) const;
  std::string place(const Row &row) const { return file_ + " line " + std::to_string(row.line); }

private:
  std::optional<std::size_t> position(const std::string &column) const;
  void read_header(int line, const std::vector<std::string> &cells, const std::vector<std::string> &known_columns);
  void read_row(int line, const std::vector<std::string> &cells);

  std::string file_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

}  // namespace swellflow
