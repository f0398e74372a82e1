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

/// What two solids do not say of themselves.
struct SlowSides {
  bool rigid = false, second_rigid = false;
  Relaxation relaxation{}, second_relaxation{};  ///< times in the unit of loss times
};

/// The law of slow impacts of a solid on another, or at a hard wall. @throws InvalidInput where there is none
[[nodiscard]] SlowLaw slow_law(const Solid& first, const std::optional<Solid>& second, const SlowSides& sides = {});

}  // namespace stoss
