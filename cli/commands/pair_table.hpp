#pragma once

#include <string>

#include "output/rows.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/table/adaptive_pairs.hpp"
#include "stoss/table/c_source.hpp"

namespace stoss::cli {

/// What a table of pairs is asked for.
struct PairOrder {
  double slowest, fastest;  ///< c
  std::string ratio;        ///< SMALLEST:GREATEST
  PairTableOptions options;
};

/// @throws InvalidInput for a ratio that is no range, and for bodies that have no ratio of radii
[[nodiscard]] PairTable compute_pairs(const Encounter& encounter, const PairOrder& order);

/// A table of pairs as a JSON document.
[[nodiscard]] std::string pairs_as_json(const PairTable& table, const TableLabel& label, const Provenance& provenance);

}  // namespace stoss::cli
