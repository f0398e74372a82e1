#include "support/csv.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace stoss::test {

std::string data_path(const std::string& name) { return STOSS_TEST_DATA "/" + name; }

std::vector<CsvRow> read_csv(const std::string& name) {
  std::ifstream file(data_path(name));
  if (!file) throw std::runtime_error("cannot read tests/data/" + name);
  std::vector<CsvRow> rows;
  std::vector<std::string> columns;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    if (columns.empty()) {
      columns = cells;
      continue;
    }
    cells.resize(columns.size());
    std::map<std::string, std::string> named;
    for (std::size_t i = 0; i < columns.size(); ++i) named[columns[i]] = cells[i];
    rows.emplace_back(std::move(named));
  }
  if (rows.empty()) throw std::runtime_error("no rows in tests/data/" + name);
  return rows;
}

}  // namespace stoss::test
