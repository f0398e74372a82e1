#pragma once

#include <optional>
#include <string>

#include "stoss/quantity.hpp"

namespace stoss::cli {

/// The units of results: those of the first body and, with a material, SI.
struct Units {
  std::optional<Scales> si{};
  bool rods = false;  ///< the first body is a rod, of length L, modulus E and cross-section A

  /// Name of a unit of the first body, as in R/c; "" for a pure number.
  [[nodiscard]] std::string own_name(Dimension dimension) const;

  /// Name of the SI unit, as in s.
  [[nodiscard]] std::string si_name(Dimension dimension) const;

  /// SI value of the unit of the first body; there must be a material.
  [[nodiscard]] double scale(Dimension dimension) const;
};

}  // namespace stoss::cli
