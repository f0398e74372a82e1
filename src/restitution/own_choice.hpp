#pragma once

#include <string>

#include "stoss/errors.hpp"

namespace stoss {

/// What to say in place of a refusal of what nobody has asked for: a step, nodes, a cutoff that restitution has chosen
/// by itself, which speed and bodies drive beyond what is computed. "" for all others, which are of what was given.
[[nodiscard]] std::string beyond_own_choice(const InvalidInput& refusal);

/// A message without the hint at a step or nodes that nobody can give here; "" if it has none.
[[nodiscard]] std::string without_hint(std::string_view message);

/// What `compute` gives. @throws NotConverged where it is refused what restitution has chosen by itself
template <typename Compute>
decltype(auto) of_own_choice(const Compute& compute) {
  try {
    return compute();
  } catch (const InvalidInput& error) {
    if (const std::string beyond = beyond_own_choice(error); !beyond.empty()) throw NotConverged(beyond);
    throw;
  } catch (const NotConverged& error) {
    if (const std::string plain = without_hint(error.what()); !plain.empty()) throw NotConverged(plain);
    throw;
  }
}

}  // namespace stoss
