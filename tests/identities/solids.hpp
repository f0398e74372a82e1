#pragma once

#include <cmath>
#include <numbers>
#include <variant>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/hollow_sphere.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"

namespace stoss::test {

/// A body as a value.
using Solid = std::variant<Disk, Rod, Sphere, HollowSphere>;

/// Whether it is a ball, solid or hollow.
inline bool is_ball(const Solid& solid) {
  return std::holds_alternative<Sphere>(solid) || std::holds_alternative<HollowSphere>(solid);
}

/// Wave speed, size and mass of a body, from its definition alone.
inline double wave_speed(const Solid& solid) {
  return std::visit([](const auto& body) { return std::sqrt(body.young / body.density); }, solid);
}

inline double size(const Solid& solid) {
  const auto* slender = std::get_if<Rod>(&solid);
  if (slender != nullptr) return slender->length;
  if (const auto* ball = std::get_if<Sphere>(&solid)) return ball->radius;
  if (const auto* ball = std::get_if<HollowSphere>(&solid)) return ball->radius;
  return std::get<Disk>(solid).radius;
}

inline double mass(const Solid& solid) {
  if (const auto* slender = std::get_if<Rod>(&solid)) return slender->density * slender->area * slender->length;
  if (const auto* ball = std::get_if<Sphere>(&solid)) {
    return 4.0 * std::numbers::pi / 3.0 * ball->density * std::pow(ball->radius, 3);
  }
  if (const auto* ball = std::get_if<HollowSphere>(&solid)) {
    const double hole = ball->inner * ball->radius;
    return 4.0 * std::numbers::pi / 3.0 * ball->density * (std::pow(ball->radius, 3) - std::pow(hole, 3));
  }
  const Disk& round = std::get<Disk>(solid);
  return std::numbers::pi * round.density * round.radius * round.radius;
}

/// Moment of inertia of a disk or a ball over mR².
inline double inertia_share(const Solid& solid) {
  if (const auto* ball = std::get_if<HollowSphere>(&solid)) {
    return 0.4 * (1.0 - std::pow(ball->inner, 5)) / (1.0 - std::pow(ball->inner, 3));
  }
  return is_ball(solid) ? 0.4 : 0.5;
}

}  // namespace stoss::test
