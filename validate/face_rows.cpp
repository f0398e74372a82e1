#include "face_rows.hpp"

#include <ostream>
#include <string>

#include "stoss/encounter/relaxing.hpp"
#include "tally_rows.hpp"

namespace validate {
namespace {

/// Cells of those numbers of a body that it has.
void write_values(std::ostream& out, const stoss::Values& values, const std::vector<const char*>& names) {
  for (const char* name : names) {
    const auto found = values.find(name);
    out << (found == values.end() ? std::string(" |") : cell("%.3g", found->second));
  }
}

}  // namespace

void write_face_points(std::ostream& out, const std::vector<Point>& points, const std::vector<Answer>& answers) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const stoss::Participant &first = points[i].encounter->first, &met = points[i].encounter->against;
    out << "| " << first.kind << " |";
    write_values(out, first.values, {"poisson", "loss_time"});
    out << ' ' << (first.relaxation ? text_of(*first.relaxation) : "") << " |";
    write_values(out, first.values, {"u0", "coat", "coat_young", "coat_quality"});
    out << ' ' << met.kind << " |";
    write_values(out, met.values, {"hardness", "poisson", "radius", "young"});
    out << cell("%.4g", points[i].speed);
    write_answer(out, points[i], answers[i], "%.4e");
  }
}

}  // namespace validate
