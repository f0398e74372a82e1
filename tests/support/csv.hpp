#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace stoss::test {

/// One line of a CSV file, by column name.
class CsvRow {
 public:
  explicit CsvRow(std::map<std::string, std::string> cells) : cells_(std::move(cells)) {}
  [[nodiscard]] bool has(const std::string& column) const { return !cells_.at(column).empty(); }
  [[nodiscard]] const std::string& text(const std::string& column) const { return cells_.at(column); }
  [[nodiscard]] double number(const std::string& column) const { return std::stod(cells_.at(column)); }
  [[nodiscard]] int integer(const std::string& column) const { return std::stoi(cells_.at(column)); }

 private:
  std::map<std::string, std::string> cells_;
};

/// Path of tests/data/`name`.
[[nodiscard]] std::string data_path(const std::string& name);

/// Reads tests/data/`name`: # comments, one header line, comma-separated values without quotes.
[[nodiscard]] std::vector<CsvRow> read_csv(const std::string& name);

}  // namespace stoss::test
