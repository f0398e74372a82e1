#pragma once

#include <string>
#include <string_view>

#include "stoss/errors.hpp"

namespace stoss {

/// What to say in place of a refusal of what nobody has asked for: a step, nodes, a cutoff that restitution has chosen
/// by itself, which speed and bodies drive beyond what is computed. "" for all others, which are of what was given.
[[nodiscard]] std::string beyond_own_choice(std::string_view refusal);

/// What `compute` gives. @throws NotConverged where it is refused what restitution has chosen by itself
template <typename Compute>
auto of_own_choice(const Compute& compute) {
  try {
    return compute();
  } catch (const InvalidInput& error) {
    if (const std::string beyond = beyond_own_choice(error.what()); !beyond.empty()) throw NotConverged(beyond);
    throw;
  }
}

}  // namespace stoss
