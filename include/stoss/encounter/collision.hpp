#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "stoss/encounter/encounter.hpp"
#include "stoss/restitution/oblique_curve.hpp"

namespace stoss {

/// How two bodies meet, as it is given: with a material of the first body in SI, otherwise in its c and c/R. Who meets
/// whom says the Encounter. Signs are those of Obliquity.
struct Collision {
  double speed = 0.0;             ///< of approach along the normal
  double tangential = 0.0;        ///< velocity of the centre of the first body along the surface
  std::optional<double> angle{};  ///< in its place: between the velocity of the centre and the normal, degrees
  double spin = 0.0;              ///< of the first body
  double second_spin = 0.0;       ///< of the second
  double friction = 0.0;          ///< μ of Coulomb's law
};

/// The collision in units of the first body.
/// @throws InvalidInput for a number out of its range, a tangential velocity beside an angle, and as validate
[[nodiscard]] ObliqueCase own_units(const Encounter& encounter, const Collision& collision);

/// A collision as a JSON object of its numbers; those that are 0 may be left out, but for the speed.
/// @throws InvalidInput for what is none
[[nodiscard]] Collision collision_from_json(std::string_view text);
[[nodiscard]] std::string to_json(const Collision& collision);

}  // namespace stoss
