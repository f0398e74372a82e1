#pragma once

#include <iosfwd>
#include <vector>

#include "judgement.hpp"

namespace validate {

/// Impacts of one kind that are judged together, and what docs/developer/validation.md says of them.
struct Set {
  const char* name;
  std::vector<Point> (*read)();
  const char* tally;   ///< before the table of its quantities
  const char* points;  ///< before that of its points
  void (*write_points)(std::ostream& out, const std::vector<Point>& points, const std::vector<Answer>& answers);
  bool calibrates = true;  ///< constants of the error bars are asked of it
};

/// Those whose impacts `judge` can tell, in the order of the page.
const std::vector<Set>& sets();

}  // namespace validate
