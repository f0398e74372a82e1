#pragma once

#include <iosfwd>
#include <vector>

#include "judgement.hpp"

namespace validate {

/// A row for each impact of rough or coated faces: body, faces, what it meets, and its error.
void write_face_points(std::ostream& out, const std::vector<Point>& points, const std::vector<Answer>& answers);

}  // namespace validate
