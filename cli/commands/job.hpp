#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "input/encounter.hpp"
#include "output/fields.hpp"
#include "output/row_run.hpp"

namespace stoss::cli {

/// The impacts of `stoss restitution`: for each Poisson's ratio all speeds.
struct Job {
  Encounter encounter;
  std::vector<double> poissons;
  std::vector<double> speeds;  ///< c
  Units units = units_of(encounter);

  [[nodiscard]] std::size_t size() const { return poissons.size() * speeds.size(); }
  [[nodiscard]] double poisson(std::size_t row) const { return poissons[row / speeds.size()]; }
  [[nodiscard]] double speed(std::size_t row) const { return speeds[row % speeds.size()]; }

  /// What meets at one of the Poisson's ratios, at any cutoff.
  [[nodiscard]] RefinableContact contact(double poisson) const;

  /// What tells a row from the others, with which it begins; with a material the speed in SI besides.
  [[nodiscard]] Row key(std::size_t row) const;

  /// A row: its key, the fields of its result, and what is said of yielding.
  template <typename Result>
  [[nodiscard]] Row row(std::size_t row, const Fields<Result>& fields, const Result& result) const {
    Row made = key(row);
    append(made, fields.row(result), yielding(encounter).row(speed(row)));
    return made;
  }

  /// All its rows, with the columns of the results; the job must outlive them.
  [[nodiscard]] RowPlan plan(const Columns& results) const;
};

/// How the values of a job are reached.
struct Method {
  RowPlan plan;
  std::function<void(RowRun& run)> compute;  ///< the next ones. @throws Interrupted, OutputError
};

/// As the paper does it, by regressions over exponential walls. The job must outlive the method.
/// @throws InvalidInput for speeds at which this does not work, and as the core
[[nodiscard]] Method extrapolating(const Job& job);

}  // namespace stoss::cli
