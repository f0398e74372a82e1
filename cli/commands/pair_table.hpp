#pragma once

#include <string>

#include "output/rows.hpp"
#include "stoss/encounter/laws.hpp"
#include "stoss/table/adaptive_pairs.hpp"
#include "stoss/table/c_source.hpp"

namespace stoss::cli {

/// A table between two speeds, c, and two ratios of radii as they are typed, SMALLEST:GREATEST.
/// @throws InvalidInput for a ratio that is no range, and for bodies that have no ratio of radii
[[nodiscard]] PairTable compute_pairs(const Encounter& encounter, double slowest, double fastest,
                                      const std::string& ratio, const PairTableOptions& options);

/// A table of pairs as a JSON document.
[[nodiscard]] std::string pairs_as_json(const PairTable& table, const TableLabel& label, const Provenance& provenance);

}  // namespace stoss::cli
