#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "stoss/restitution/restitution.hpp"

namespace validate {

/// What restitution() gives with an error, in this order everywhere.
enum Quantity : std::size_t { lost_fraction, restitution_coefficient, contact_time, max_force, max_compression };
inline constexpr std::size_t quantities = 5;
inline constexpr std::array<const char*, quantities> quantity_names{"1−ε²", "ε", "contact time", "greatest force",
                                                                    "greatest compression"};

template <typename T>
using PerQuantity = std::array<T, quantities>;

/// An impact of a disk at a hard wall with reference values; their `error` is the uncertainty.
struct Point {
  double poisson = 0.0;
  double speed = 0.0;
  PerQuantity<std::optional<stoss::Estimate>> reference;
  std::optional<stoss::Estimate> finite_elements;  ///< of ε
};

/// Those of validate/reference.csv, then those of tests/data/restitution_hard_wall.csv.
/// @throws std::runtime_error if a file cannot be read
std::vector<Point> read_points();

}  // namespace validate
