#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "encounter.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "table.hpp"
#include "units.hpp"

namespace stoss::cli {

/// The impacts of `stoss restitution`: for each Poisson number all speeds.
struct Job {
  Encounter encounter;
  std::vector<double> poissons;
  std::vector<double> speeds;  ///< c
  Units units;

  [[nodiscard]] std::size_t size() const { return poissons.size() * speeds.size(); }
  [[nodiscard]] double poisson(std::size_t row) const { return poissons[row / speeds.size()]; }
  [[nodiscard]] double speed(std::size_t row) const { return speeds[row % speeds.size()]; }

  /// What tells a row from the others, with which its record begins; with a material the speed in SI besides.
  [[nodiscard]] Record key(std::size_t row) const;

  /// The whole record of a row.
  template <typename Result>
  [[nodiscard]] Record record(std::size_t row, const Table<Result>& table, const Result& result) const {
    Record record = key(row);
    add_quantities(record, table, result, units);
    encounter.add_yield(record, speed(row));
    return record;
  }
};

/// What is said of one impact of the job.
struct Row {
  Record record;
  nlohmann::ordered_json details = nlohmann::ordered_json::object();  ///< for JSON only
  std::string trouble;                                                ///< why the value is not what was asked for
};

/// The rows of a job that are there, and what has to be said about them at the end.
class Sweep {
 public:
  /// @param columns as csv_columns writes them
  Sweep(Job job, const OutputArguments& output, const std::string& columns);

  /// Takes note of a row of an earlier run. @throws InvalidInput unless it is the next one of this job
  void take(const std::vector<std::string>& cells);

  /// Writes the next row. @throws OutputError
  void add(const Row& row, Report& report);

  /// Says on a terminal what the next row has come to, if it takes long.
  void wait(const std::string& state) { progress_.wait(state); }

  [[nodiscard]] const Job& job() const { return job_; }
  [[nodiscard]] std::size_t done() const { return done_; }

  /// Warns of rows without the value that was asked for. Returns the exit code.
  [[nodiscard]] int conclude() const;

 private:
  [[nodiscard]] bool has(const std::vector<std::string>& cells, const std::string& column,
                         const std::string& value) const;
  void count(const std::vector<std::string>& cells);

  Job job_;
  const OutputArguments& output_;
  std::vector<std::string> columns_;
  Progress progress_;
  std::size_t done_ = 0;
  std::size_t marked_ = 0;
  bool beyond_small_strain_ = false;
  bool beyond_yield_ = false;
};

}  // namespace stoss::cli
