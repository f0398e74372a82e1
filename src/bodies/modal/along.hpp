#pragma once

#include <functional>

#include "bodies/modal/alternatives.hpp"
#include "bodies/modal/point_modes.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::modal {

/// Refuses friction of a body whose modes or turning join both directions.
/// @throws InvalidInput where it has no tangent, or one of them does by more than a share of 0.05
void require_apart(const ModalBody& its);

/// A body by its modes at a point against forces along t (Body::along): what moves it by ψ + χ_t r², and the static
/// response along a sphere of its curvature, or a half-space, with its own constant c_t.
/// @param body   along its normal
/// @param uneven by which its surface is taken to be softer, 0 but of an alternative
[[nodiscard]] Body along(const Body& body, const ModalBody& its, const PointModes& modes, const Unevenness& uneven);

/// The same body against forces alike all around the normal (Body::outward): its modes move all rings along the normal,
/// while friction outward only meets the surroundings of the point.
[[nodiscard]] Body outward(const Body& body, const ModalBody& its, const PointModes& modes);

/// Body::cross_mobility of Validity, from the modes that are kept; none without a tangent.
[[nodiscard]] std::function<double(double duration)> cross_mobility(const ModalBody& its, const PointModes& modes);

}  // namespace stoss::bodies::modal
