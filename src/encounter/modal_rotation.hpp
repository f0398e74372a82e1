#pragma once

#include <string>

#include "encounter/json_values.hpp"
#include "stoss/bodies/modal_body.hpp"

namespace stoss {

/// Reads `rotation` and `tangent` of the file of a body whose whole mass is there already: the mass that its point
/// feels along the normal, and how friction moves it (PointTangent). @throws InvalidInput as modal_body_from_json
void read_rotation(const std::string& where, const json::Json& given, ModalBody& body);

/// As a file has it that gives no rotation.
[[nodiscard]] json::Json tangent_to_json(const PointTangent& tangent);

}  // namespace stoss
