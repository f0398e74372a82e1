#pragma once

#include <optional>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// How finely an impact is computed, apart from the cutoff of its bodies. What is left open is recommended.
struct Resolution {
  std::optional<double> step{};        ///< Δt, R/c (docs/developer/numerics.md)
  std::optional<int> nodes{};          ///< of the contact grid
  std::optional<double> half_width{};  ///< of the contact grid, R; otherwise 1.25 times the expected one of the contact
  Tail tail = Tail::radiating;
};

/// The resolution of one impact, with nothing left open: as a Resolution it repeats the impact bit by bit.
struct FixedResolution {
  double step = 0.0;        ///< Δt, R/c
  int nodes = 0;            ///< of the contact grid
  double half_width = 0.0;  ///< of the contact grid, R; 0 for a single point
  Tail tail = Tail::radiating;

  explicit operator Resolution() const {
    return {step, nodes, half_width > 0.0 ? std::optional(half_width) : std::nullopt, tail};
  }
};

/// The resolution asked for, with what is recommended for an impact at this speed where it is left open.
/// @throws InvalidInput for a speed, and a resolution, out of range
[[nodiscard]] FixedResolution fixed_resolution(const Contact& contact, double speed, const Resolution& asked = {});

}  // namespace stoss
