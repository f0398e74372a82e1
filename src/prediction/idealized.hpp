#pragma once

#include "stoss/encounter/encounter.hpp"

namespace stoss::prediction {

/// The same encounter of bodies that yield where the strength of their material is known.
[[nodiscard]] Encounter with_yield(Encounter encounter);

/// The same encounter of smooth, bare faces.
[[nodiscard]] Encounter with_smooth_faces(Encounter encounter);

}  // namespace stoss::prediction
