#pragma once

#include <memory>

#include "stoss/body/body.hpp"

namespace stoss {

/// A body as a round one that yields as much: where its principal curvatures differ, Hertz' contact is an ellipse, and
/// a force F presses both bodies together as far as a ball of the curvature H does. With the relative mean curvature M
/// and t = |A − B|/(A + B) of the relative ones A, B
///
///   δ³ = 9 F² H/(16 E*²) = (K(e) 3F/(2πE*a))³,   H/M = 1 − 0.66713 t² − 0.12242 t⁴ − 0.08633 t⁶   to 2·10⁻⁵ for t ≤
///   0.6
///
/// (Johnson, Contact Mechanics, 1985, eq. 4.26; coefficients: least squares on 60 ratios from 1.05 to 4).
///
/// @param other curvature of what it meets, in its own units
/// @return the body itself if it is round
/// @throws InvalidInput where A and B are further apart than 4 : 1
[[nodiscard]] std::shared_ptr<const Body> as_round(std::shared_ptr<const Body> body, double other);

/// Refuses a contact that is far from a circle, as above.
void require_round(const Body& body, double other);

}  // namespace stoss
