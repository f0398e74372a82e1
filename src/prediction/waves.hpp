#pragma once

#include "stoss/restitution/restitution.hpp"

namespace stoss::prediction {

/// Share of the energy that waves take.
[[nodiscard]] double waves_of(const Restitution& its);

/// Share of it that runs away in a block or a plate: heat and flow count with each body, so the modes tell.
[[nodiscard]] double radiated(const Restitution& its, bool block);

}  // namespace stoss::prediction
