#pragma once

#include <functional>
#include <string>
#include <vector>

#include "input/encounter.hpp"
#include "output/fields.hpp"
#include "stoss/quasistatic/rayleigh.hpp"

namespace stoss::cli {

/// A slow impact, and what is said of it besides its columns.
struct SlowImpactRow {
  Row row;
  bool beyond_perturbation = false;
  std::vector<quasistatic::DrivenMode> modes;
};

/// A body as `stoss quasistatic` has it: by one of the laws of compression, at a wall. Speeds are in c, lengths in R.
struct QuasistaticBody {
  double poisson = 0.0;
  Allowed speeds;
  double greatest_compression = 0.0;  ///< where the law or the static contact ends

  /// Slow impacts, with modes up to a cutoff.
  Columns impact_columns;
  std::function<std::function<SlowImpactRow(double speed)>(double cutoff)> impacts;

  /// Static contacts.
  Columns contact_columns;
  std::function<Row(double compression)> compress;
};

/// Compressions that a static contact takes, R.
inline constexpr double least_compression = 1e-12, greatest_compression = 0.5;

/// A disk, which touches the wall along a line, or a sphere, which touches it at a point.
/// @throws InvalidInput for a law of other bodies
[[nodiscard]] QuasistaticBody quasistatic_body(const Encounter& encounter, const std::string& law);

}  // namespace stoss::cli
