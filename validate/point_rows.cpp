#include "point_rows.hpp"

#include <ostream>

#include "tally_rows.hpp"

namespace validate {
namespace {

void write_place(std::ostream& out, const Point& point) {
  out << "|";
  if (point.half_space) out << (point.rigid ? " rigid" : "") << (point.sphere ? " sphere |" : " disk |");
  if (point.loss_time > 0.0) out << (point.sphere ? " sphere |" : " disk |") << cell("%g", point.loss_time);
  if (point.temperature > 0.0) out << (point.sphere ? " sphere |" : " disk |");
  out << cell("%g", point.poisson);
  if (point.loss_time > 0.0) {
    if (point.against) {
      out << cell("%g", point.against->loss_time) << cell("%g", point.against->poisson)
          << cell("%g", point.against->radius);
    } else {
      out << " | | |";
    }
  } else if (point.half_space) {
    out << cell("%g", point.against->poisson) << cell("%g", point.against->young) << cell("%g", point.against->density);
  } else if (point.temperature > 0.0) {
    if (point.against) {
      out << cell("%g", point.against->poisson) << cell("%g", point.against->radius)
          << cell("%g", point.against->young);
    } else {
      out << " | | |";
    }
  } else if (point.against) {
    out << cell("%g", point.against->poisson) << cell("%g", point.against->radius) << cell("%g", point.against->young)
        << cell("%g", point.against->density);
  }
  if (point.inner > 0.0) out << cell("%g", point.inner);
  out << cell("%.4g", point.speed);
  if (point.temperature > 0.0) out << cell("%g", point.temperature) << cell("%g", point.highest);
}

}  // namespace

void write_plain_points(std::ostream& out, const std::vector<Point>& points, const std::vector<Answer>& answers) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    write_place(out, points[i]);
    write_answer(out, points[i], answers[i]);
  }
}

}  // namespace validate
