#pragma once

#include <variant>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/hollow_sphere.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/body/body.hpp"

namespace stoss {

/// What has a surface that deforms, as a value: its size and material, in any consistent units.
using Solid = std::variant<Disk, Sphere, HollowSphere, Rod, HalfSpace, HalfPlane, Plate, Strip, ModalBody>;

/// Makes the body of a solid at any cutoff. @throws InvalidInput as the maker of its kind
[[nodiscard]] BodyMaker maker(const Solid& solid);

/// The same of a material that relaxes from the modulus of the solid, with times in the unit of time of its numbers.
/// @throws InvalidInput as relaxing
[[nodiscard]] BodyMaker maker(const Solid& solid, const Relaxation& relaxation);

}  // namespace stoss
