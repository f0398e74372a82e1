#pragma once

#include <cmath>
#include <numbers>
#include <variant>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"

namespace stoss::test {

/// A body as a value.
using Solid = std::variant<Disk, Rod, Sphere>;

/// Wave speed, size and mass of a body, from its definition alone.
inline double wave_speed(const Solid& solid) {
  return std::visit([](const auto& body) { return std::sqrt(body.young / body.density); }, solid);
}

inline double size(const Solid& solid) {
  const auto* slender = std::get_if<Rod>(&solid);
  if (slender != nullptr) return slender->length;
  if (const auto* ball = std::get_if<Sphere>(&solid)) return ball->radius;
  return std::get<Disk>(solid).radius;
}

inline double mass(const Solid& solid) {
  if (const auto* slender = std::get_if<Rod>(&solid)) return slender->density * slender->area * slender->length;
  if (const auto* ball = std::get_if<Sphere>(&solid)) {
    return 4.0 * std::numbers::pi / 3.0 * ball->density * std::pow(ball->radius, 3);
  }
  const Disk& round = std::get<Disk>(solid);
  return std::numbers::pi * round.density * round.radius * round.radius;
}

}  // namespace stoss::test
