// How the material of a body relaxes, in the units of what it is made from.
#include <cmath>
#include <variant>

#include "encounter/participant.hpp"
#include "stoss/relaxation/constant_quality.hpp"

namespace stoss {
namespace {

double size_of(const Solid& solid) {
  return std::visit(
      [](const auto& its) {
        if constexpr (requires { its.radius; }) return its.radius;
        if constexpr (requires { its.length; }) return its.length;
        if constexpr (requires { own_length(its); }) return own_length(its);
        return 0.0;
      },
      solid);
}

/// R/c of a body, of what has no size with that of the first.
double own_time(const Solid& solid, const Solid& first) {
  const double size = size_of(solid) > 0.0 ? size_of(solid) : size_of(first);
  return size / std::visit([](const auto& its) { return std::sqrt(its.young / its.density); }, solid);
}

}  // namespace

Relaxation relaxation_of(const Encounter& encounter, const Participant& of, const Solid& solid) {
  const Losses its = losses_of(of);
  if (its.quality == 0.0) {
    const bool as_given = !encounter.first.material || encounter.first.kind == "rod";
    return as_given ? its.relaxation : in_time(its.relaxation, 1.0 / si_scales(encounter)->time);
  }
  return in_time(constant_quality(its.quality, lowest_of_body, highest_of_body),
                 own_time(solid, first_solid(encounter)));
}

}  // namespace stoss
