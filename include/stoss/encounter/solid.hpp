#pragma once

#include <optional>
#include <variant>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/body/body.hpp"
#include "stoss/table/slow_law.hpp"

namespace stoss {

/// What has a surface that deforms, as a value: its size and material, in any consistent units.
using Solid = std::variant<Disk, Sphere, Rod, HalfSpace, HalfPlane>;

/// Makes the body of a solid at any cutoff. @throws InvalidInput as the maker of its kind
[[nodiscard]] BodyMaker maker(const Solid& solid);

/// The law of slow impacts of a solid on another, or at a hard wall. @throws InvalidInput where there is none
/// @param rigid,second_rigid whether the first, and what it meets, is rigid
[[nodiscard]] SlowLaw slow_law(const Solid& first, const std::optional<Solid>& second, bool rigid = false,
                               bool second_rigid = false);

}  // namespace stoss
