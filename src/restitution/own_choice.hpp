#pragma once

#include <string>

#include "stoss/errors.hpp"

namespace stoss {

/// What to say in place of a refusal of what nobody has asked for: a step, nodes, a cutoff that restitution has chosen
/// by itself, which speed and bodies drive beyond what is computed. "" for all others, which are of what was given.
[[nodiscard]] std::string beyond_own_choice(const InvalidInput& refusal);

/// What `compute` gives. @throws NotConverged where it is refused what restitution has chosen by itself
template <typename Compute>
decltype(auto) of_own_choice(const Compute& compute) {
  try {
    return compute();
  } catch (const InvalidInput& error) {
    if (const std::string beyond = beyond_own_choice(error); !beyond.empty()) throw NotConverged(beyond);
    throw;
  } catch (const NotConverged& error) {
    if (!error.input().empty()) throw NotConverged(error.failure());  // a step or nodes, which nobody can give here
    throw;
  }
}

}  // namespace stoss
