#pragma once

#include <optional>

#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/solid.hpp"
#include "stoss/table/mixture.hpp"
#include "stoss/table/slow_law.hpp"

/// What is known of an encounter in closed form, or computed for all ratios of the radii.
namespace stoss {

/// Of any ratio of radii, for a table of pairs; that of the two does not count.
/// @throws InvalidInput unless these are elastic disks or spheres
[[nodiscard]] Mixture mixture(const Encounter& encounter);

/// The law of its slow impacts. @throws InvalidInput for bodies of which there is none
[[nodiscard]] SlowLaw slow_law(const Encounter& encounter);

/// The law of slow impacts of a solid on another, or at a hard wall. @throws InvalidInput where there is none
/// @param rigid,second_rigid whether the first, and what it meets, is rigid
[[nodiscard]] SlowLaw slow_law(const Solid& first, const std::optional<Solid>& second, bool rigid = false,
                               bool second_rigid = false);

}  // namespace stoss
