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

/// Unit of time of the numbers of a solid, in that of what was given.
double unit_of_time(const Encounter& encounter) {
  const bool as_given = !encounter.first.material || encounter.first.kind == "rod";
  return as_given ? 1.0 : si_scales(encounter)->time;
}

Relaxation relaxation_of(const Encounter& encounter, const Losses& its, const Solid& solid) {
  if (its.quality == 0.0) return in_time(its.relaxation, 1.0 / unit_of_time(encounter));
  return in_time(constant_quality(its.quality, lowest_of_body, highest_of_body),
                 own_time(solid, first_solid(encounter)));
}

}  // namespace

Relaxation relaxation_of(const Encounter& encounter, const Participant& of, const Solid& solid) {
  return layers_differ(of) ? Relaxation{} : relaxation_of(encounter, losses_of(of), solid);
}

std::vector<MaterialLoss> layer_losses(const Encounter& encounter, const Participant& of, const Solid& plate) {
  std::vector<MaterialLoss> all;
  for (const Losses& its : losses_of_layers(of)) {
    all.push_back({its.loss_time / unit_of_time(encounter), relaxation_of(encounter, its, plate)});
  }
  return all;
}

}  // namespace stoss
