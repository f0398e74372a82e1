#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "record.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/quasistatic/rayleigh.hpp"
#include "units.hpp"

namespace stoss::cli {

/// Compressions that a static contact takes, R.
inline constexpr double least_compression = 1e-12, greatest_compression = 0.5;

/// What a row of slow impacts says besides its columns.
struct SlowRow {
  bool beyond_perturbation = false;
  std::vector<quasistatic::DrivenMode> modes;
};

/// A body as `stoss quasistatic` has it: by one of the laws of compression, at a wall. Speeds are in c, lengths in R.
struct QuasistaticBody {
  Units units;
  double poisson = 0.0;
  SpeedRange speeds;
  double greatest_compression = 0.0;  ///< where the law or the static contact ends

  /// With modes up to a cutoff: adds what a slow impact is to a record.
  std::function<std::function<SlowRow(double speed, Record& record)>(double cutoff)> impacts;

  /// Adds what a static contact is to a record.
  std::function<void(double compression, Record& record)> compress;

  std::optional<double> yield_speed{};  ///< m/s, of a sphere with a yield strength
};

/// A disk, which touches the wall along a line. @throws InvalidInput for a law of other bodies
[[nodiscard]] QuasistaticBody line_quasistatic(const Encounter& disk, const std::string& law);

/// A sphere, which touches it at a point. @throws InvalidInput for a law of other bodies
[[nodiscard]] QuasistaticBody point_quasistatic(const Encounter& sphere, const std::string& law);

}  // namespace stoss::cli
