#pragma once

#include <optional>

#include "stoss/contact/contact.hpp"
#include "stoss/contact/tail.hpp"

namespace stoss {

/// How finely an impact is computed, apart from the cutoff of its bodies. What is left open is recommended.
struct Resolution {
  std::optional<double> step{};        ///< Δt, R/c; otherwise recommended_step
  std::optional<int> nodes{};          ///< of the contact grid; otherwise recommended_nodes
  std::optional<double> half_width{};  ///< of the contact grid, R; otherwise 1.25 times the expected one of the contact
  Tail tail = Tail::radiating;         ///< how the modes above the cutoff answer a hard contact
};

/// Recommended time step Δt of an impact, R/c (docs/numerics.md).
[[nodiscard]] double recommended_step(const Contact& contact, double speed, Tail tail = Tail::radiating);

/// Recommended number of contact nodes of an impact.
[[nodiscard]] int recommended_nodes(const Contact& contact, double speed);

}  // namespace stoss
