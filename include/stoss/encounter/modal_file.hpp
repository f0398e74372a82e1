#pragma once

#include <string>
#include <string_view>

#include "stoss/bodies/modal_body.hpp"

/// A body by its modes at a point as a JSON document in SI, which finite elements write and every face reads:
///
///   {"format": "stoss modal body 1", "name": "bell", "origin": "…",
///    "mass": 3.1, "rotation": {"inertia": [[…], […], […]], "point": [x, y, z], "normal": [x, y, z]},
///    "curvature": [1.2, 5.0], "young": 1e11, "poisson": 0.34, "density": 8600, "loss_time": 0,
///    "compliance": -2e-12, "compliance_error": 1e-14, "complete_to": 20000,
///    "tangent": {"direction": [x, y, z], "compliance": -1e-12, "compliance_error": 1e-14},
///    "modes": {"frequency": […], "displacement": […], "displacement_curvature": […],
///              "frequency_error": […], "displacement_error": […],
///              "tangential_displacement": […], "tangential_displacement_curvature": […],
///              "tangential_displacement_error": […]}}
///
/// mass in kg; inertia about the centre of mass in kg m², the point from there in m, with its outward normal: without
/// `rotation` the impact is central. Principal curvatures in 1/m, or one for both. Frequencies in Hz, displacements in
/// kg^(−1/2), their curvature in kg^(−1/2) m^(−2), compliance in m/N, as ModalBody has them. Origin, rotation,
/// loss_time, complete_to (the highest frequency), displacement_curvature and errors may be left out.
///
/// Friction needs a tangent, its direction in the plane of impact, with the static compliance c_t of PointTangent, and
/// what each mode moves the point along it. Without `rotation` the tangent also has `inertia` and `arm`, those of the
/// round body as which friction turns it, 0 of one that does not turn; and, if they are others than the mass of the
/// body and 0, `mass` and `cross`.
namespace stoss {

/// Reads a document. @param where named by refusals
/// @throws InvalidInput with one line: what is wrong where, and what is allowed; as modal_body
[[nodiscard]] ModalBody modal_body_from_json(std::string_view text, const std::string& where = "body");

/// Writes a document that reads back as the same body, central with the mass that its point feels.
[[nodiscard]] std::string to_json(const ModalBody& body);

}  // namespace stoss
