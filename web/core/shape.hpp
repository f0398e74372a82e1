#pragma once

#include <emscripten/val.h>

#include "encounter.hpp"
#include "inside.hpp"

namespace stoss::web {

/// Shape of a mode of a body (0: the first, 1: the second) at points of it, maximum displacement 1.
/// @throws InvalidInput for a mode that the body does not have below cutoffs that are computed at once
[[nodiscard]] emscripten::val shape(const Meeting& meeting, int body, int order, int index, const Points& points);

}  // namespace stoss::web
