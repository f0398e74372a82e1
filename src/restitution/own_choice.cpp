#include "restitution/own_choice.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace stoss {

std::string beyond_own_choice(const InvalidInput& refusal) {
  using Needs = std::pair<std::string_view, std::string_view>;
  constexpr std::array needs{
      Needs{"step", "shorter time steps than are taken"}, Needs{"nodes", "more points of contact than are computed"},
      Needs{"half_width", "a wider contact than the bodies have room for"},
      Needs{"cutoff", "more modes than are computed"}, Needs{"duration", "a longer contact than is computed"}};
  for (const auto& [name, what] : needs) {
    if (refusal.name() != name) continue;
    return "restitution: an impact of these bodies at this speed needs " + std::string(what) +
           " (another speed, or bodies that are less unlike)";
  }
  return {};
}

}  // namespace stoss
