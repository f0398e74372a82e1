#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "encounter.hpp"
#include "sweep.hpp"
#include "table.hpp"
#include "units.hpp"
#include "yield.hpp"

namespace stoss::cli {

/// The impacts of `stoss restitution`: for each Poisson's ratio all speeds.
struct Job {
  Encounter encounter;
  std::vector<double> poissons;
  std::vector<double> speeds;  ///< c
  Units units;

  [[nodiscard]] std::size_t size() const { return poissons.size() * speeds.size(); }
  [[nodiscard]] double poisson(std::size_t row) const { return poissons[row / speeds.size()]; }
  /// What meets at one of the Poisson's ratios, at any cutoff.
  [[nodiscard]] RefinableContact contact(double poisson) const;

  [[nodiscard]] double speed(std::size_t row) const { return speeds[row % speeds.size()]; }

  /// What tells a row from the others, with which its record begins; with a material the speed in SI besides.
  [[nodiscard]] Record key(std::size_t row) const;

  /// The whole record of a row.
  template <typename Result>
  [[nodiscard]] Record record(std::size_t row, const Table<Result>& table, const Result& result) const {
    Record record = key(row);
    add_quantities(record, table, result, units);
    add_yield(record, units, yield_speed(encounter), speed(row));
    return record;
  }

  /// Its rows; the job must outlive them. @param columns as csv_columns writes them
  [[nodiscard]] Rows rows(const std::string& columns) const;
};

}  // namespace stoss::cli
