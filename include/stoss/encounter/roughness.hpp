#pragma once

#include "stoss/encounter/encounter.hpp"

/// How rough faces are given.
namespace stoss {

/// u₀ of elastic asperities, whose pressure is p₀ e^{−g/u₀} at the mean gap g, over their rms height. Of surfaces that
/// are fractal over the usual ranges of lengths u₀ is 0.4 to 0.5 of it: B. N. J. Persson, Phys. Rev. Lett. 99, 125502
/// (2007); C. Yang and B. N. J. Persson, J. Phys.: Condens. Matter 20, 215214 (2008).
inline constexpr double asperities_over_rms = 0.45;
inline constexpr double asperities_over_rms_error = 0.05;

/// u₀ of the face of one of both, in the unit in which its sizes are given: its `u0`, or the factor times its
/// `roughness`; of an exponential wall 1/hardness in R. 0: smooth.
/// @throws InvalidInput for both, and for numbers below 0
[[nodiscard]] double asperities_of(const Participant& of);

/// u₀ between both faces together, √(u₁² + u₂²), R of the first body (of a rod L). @throws InvalidInput as above
[[nodiscard]] double asperities_of(const Encounter& encounter);

/// The body with a rough face, as rough makes it of u₀ in the unit in which its size was given (BodyScale::length).
/// @param asperities u₀, 0 to 1000 radii of the body @throws InvalidInput below 0; above, when the body is made
[[nodiscard]] BodyMaker with_asperities(const BodyMaker& maker, double asperities);

/// Refuses rough faces, for what knows smooth ones only. @param what refuses them
void refuse_rough(const Encounter& encounter, const std::string& what);

}  // namespace stoss
