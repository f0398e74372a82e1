#pragma once

#include "stoss/encounter/encounter.hpp"

namespace stoss::prediction {

/// The same encounter of bodies that do not yield.
[[nodiscard]] Encounter without_yield(Encounter encounter);

/// The same encounter of bodies that yield where the strength of their material is known, with smooth, bare faces:
/// coats spread the pressure, and nothing is known of what yields below one. Asperities are much lower than a dent.
[[nodiscard]] Encounter as_it_yields(Encounter encounter);

/// The same encounter of smooth, bare faces.
[[nodiscard]] Encounter with_smooth_faces(Encounter encounter);

}  // namespace stoss::prediction
