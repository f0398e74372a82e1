#pragma once

#include <iosfwd>
#include <vector>

#include "judgement.hpp"

namespace validate {

/// A row for each point of a set whose table has a body's numbers alone: its place, and its error.
void write_plain_points(std::ostream& out, const std::vector<Point>& points, const std::vector<Answer>& answers);

}  // namespace validate
