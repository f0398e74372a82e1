#pragma once

#include <functional>

#include "stoss/body/body.hpp"

namespace stoss {

/// The body, changed in what does not depend on its modes, with all that is made from it changed too.
/// @param change of any of them, which may have units of its own
[[nodiscard]] Body changed(Body body, const std::function<Body(const Body&)>& change);

/// R/E of a body in units that all bodies have in common, as coats have it.
[[nodiscard]] double unit_of_coats(const Body& body);

}  // namespace stoss
