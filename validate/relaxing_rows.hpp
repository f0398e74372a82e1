#pragma once

#include <iosfwd>
#include <vector>

#include "judgement.hpp"

namespace validate {

/// A row for each body that relaxes: its terms, those of what it meets, and its error.
void write_relaxing_points(std::ostream& out, const std::vector<Point>& points, const std::vector<Answer>& answers);

}  // namespace validate
