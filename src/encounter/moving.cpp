#include "stoss/encounter/moving.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Radius, density, and mass and moment of inertia over those of a solid sphere.
struct Ball {
  double radius = 0.0, density = 0.0, share_of_mass = 1.0, share_of_inertia = 1.0;
};

std::optional<Ball> ball_of(const Solid& solid) {
  if (const auto* ball = std::get_if<Sphere>(&solid)) return Ball{ball->radius, ball->density};
  if (const auto* ball = std::get_if<HollowSphere>(&solid)) {
    return Ball{ball->radius, ball->density, 1.0 - std::pow(ball->inner, 3), 1.0 - std::pow(ball->inner, 5)};
  }
  return std::nullopt;
}

/// Of a solid, at a unit of length and of density.
MovingBody<3> body_of(const Solid& solid, double length, double density) {
  if (const auto* disk = std::get_if<Disk>(&solid)) {
    const double r = disk->radius / length, mass = std::numbers::pi * disk->density / density * r * r;
    return {1.0 / mass, 2.0 / (mass * r * r), r, {}, {}};
  }
  if (const auto ball = ball_of(solid)) {
    const double r = ball->radius / length, mass = 4.0 / 3.0 * std::numbers::pi * ball->density / density * r * r * r;
    return {1.0 / (mass * ball->share_of_mass), 2.5 / (mass * ball->share_of_inertia * r * r), r, {}, {}};
  }
  if (std::holds_alternative<Rod>(solid))
    throw InvalidInput::conflict("body", "rods cannot be moved by collide, only disks and spheres");
  if (std::holds_alternative<ModalBody>(solid)) {
    throw InvalidInput::conflict(
        "body", "modal bodies cannot be moved by collide, only disks and spheres, which turn alike about any axis");
  }
  return {0.0, 0.0, 0.0, {}, {}};
}

MovingBody<3> scaled(MovingBody<3> body, double factor, int dimension) {
  body.inverse_mass /= std::pow(factor, dimension);
  body.inverse_inertia /= std::pow(factor, dimension + 2);
  body.radius *= factor;
  return body;
}

}  // namespace

MovingPair MovingPair::resized(double radius, double second_radius) const {
  return {scaled(first, radius / first.radius, dimension), scaled(second, second_radius / second.radius, dimension),
          dimension};
}

MovingPair moving_pair(const Encounter& encounter) {
  validate(encounter);
  const Solid first = first_solid(encounter);
  const auto second = second_solid(encounter);
  double length = 1.0, density = 1.0;
  const auto* disk = std::get_if<Disk>(&first);
  if (disk != nullptr) length = disk->radius, density = disk->density;
  if (const auto ball = ball_of(first)) length = ball->radius, density = ball->density;
  return {body_of(first, length, density), second ? body_of(*second, length, density) : MovingBody<3>{0.0, 0.0, 0.0},
          disk != nullptr ? 2 : 3};
}

}  // namespace stoss
