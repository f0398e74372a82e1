#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "progress.hpp"
#include "report.hpp"

namespace stoss::cli {

/// The cells of a row as CSV has them, by the names of their columns without units.
using Cells = std::map<std::string, std::string>;

/// What rows there will be.
struct Rows {
  std::size_t size = 0;
  std::string columns;                                 ///< as csv_columns writes them
  std::function<Record(std::size_t row)> key;          ///< with which the record of this row begins, and of no other
  std::function<std::string(std::size_t row)> name;    ///< of a row, in warnings
  std::optional<double> yield_speed{};                 ///< m/s, where a yield strength was given
  std::function<void(const Cells& cells)> observer{};  ///< called with each row, also those of an earlier run
};

/// A row and what describes it.
struct Row {
  Record record;
  nlohmann::ordered_json details = nlohmann::ordered_json::object();  ///< for JSON only
  std::string trouble;                                                ///< why the value is not what was asked for
};

/// The rows that are there, and what has to be said about them at the end.
class Sweep {
 public:
  Sweep(Rows rows, const OutputArguments& output);

  /// Takes note of a row of an earlier run. @throws InvalidInput unless it is the next one
  void take(const std::vector<std::string>& cells);

  /// Writes the next row. @throws OutputError
  void add(const Row& row, Report& report);

  /// Says on a terminal what the next row has come to, if it takes long.
  void wait(const std::string& state) { progress_.wait(state); }

  [[nodiscard]] const std::string& columns() const { return rows_.columns; }
  [[nodiscard]] std::size_t size() const { return rows_.size; }
  [[nodiscard]] std::size_t done() const { return done_; }

  /// Warns of rows without the value that was asked for. Returns the exit code.
  [[nodiscard]] int conclude() const;

 private:
  void count(const std::vector<std::string>& row);

  Rows rows_;
  const OutputArguments& output_;
  std::vector<std::string> names_;  // of the columns, without units
  Progress progress_;
  std::size_t done_ = 0;
  std::size_t marked_ = 0;
  bool beyond_small_strain_ = false;
  bool beyond_yield_ = false;
};

}  // namespace stoss::cli
