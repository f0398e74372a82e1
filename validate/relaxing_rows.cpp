#include "relaxing_rows.hpp"

#include <ostream>
#include <string>

#include "stoss/encounter/relaxing.hpp"
#include "tally_rows.hpp"

namespace validate {

void write_relaxing_points(std::ostream& out, const std::vector<Point>& points, const std::vector<Answer>& answers) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& point = points[i];
    out << "| " << (point.sphere ? "sphere" : "disk") << " | " << text_of(point.relaxation) << " |"
        << cell("%g", point.poisson);
    if (point.against) {
      out << cell("%g", point.against->poisson)
          << (point.half_space ? std::string(" half-space |") : cell("%g", point.against->radius)) << " "
          << text_of(point.against_relaxation) << " |";
    } else {
      out << " | | |";
    }
    out << cell("%.4g", point.speed);
    write_answer(out, point, answers[i]);
  }
}

}  // namespace validate
