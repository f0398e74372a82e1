#include "modal_report.hpp"

#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "judgement.hpp"
#include "modal_points.hpp"
#include "modal_text.hpp"
#include "tally_rows.hpp"

namespace validate {
namespace {

struct Share {
  const char* name;
  std::function<bool(const ModalCase&)> is;
};

bool meets(const ModalCase& its, const char* what) { return its.against == what; }

bool is_uncertain(const ModalCase& its) { return its.compliance_error > 0.0; }

const std::vector<Share>& shares() {
  static const std::vector<Share> all{
      {"all", [](const ModalCase&) { return true; }},
      {"exact numbers", [](const ModalCase& its) { return !is_uncertain(its); }},
      {"exact, of true spheres", [](const ModalCase& its) { return !is_uncertain(its) && its.flatter == 0.0; }},
      {"numbers with errors", is_uncertain},
      {"at the wall", [](const ModalCase& its) { return meets(its, "wall"); }},
      {"at spheres", [](const ModalCase& its) { return meets(its, "sphere") || meets(its, "its like"); }},
      {"on half-spaces", [](const ModalCase& its) { return meets(its, "half_space"); }},
      {"on plates", [](const ModalCase& its) { return meets(its, "plate"); }},
  };
  return all;
}

Answer answer_to(const ModalCase& its) {
  const stoss::RefinableContact contact = given(its);
  try {
    const stoss::Restitution result = best(contact, its.speed, {});
    return {{result.lost_fraction, result.restitution, result.contact_time, result.impulse_time, result.max_force,
             result.max_compression},
            result.converged,
            result.finest.cutoff};
  } catch (const std::exception& error) {
    std::cerr << its.against << ", " << its.speed << ": " << error.what() << '\n';
    Answer none;
    none.value.fill({0.0, std::numeric_limits<double>::infinity()});
    return none;
  }
}

Tally tally_of(const std::vector<ModalPoint>& points, const std::vector<Answer>& answers, const Share& share,
               Quantity quantity) {
  std::vector<Comparison> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& reference = points[i].reference[quantity];
    if (share.is(points[i].its) && reference) all.push_back({answers[i].value[quantity], *reference});
  }
  return tally(all);
}

void write_point(std::ostream& out, const ModalPoint& point, const Answer& answer) {
  const ModalCase& its = point.its;
  const stoss::Estimate& reference = *point.reference[lost_fraction];
  const stoss::Estimate& value = answer.value[lost_fraction];
  const Deviation off = deviation(value, reference);
  out << "|" << cell("%g", its.poisson) << cell("%g", its.complete_to) << (its.bends ? " χ |" : " |")
      << cell("%g", its.flatter) << (is_uncertain(its) ? " yes | " : " | ") << its.against << " |"
      << (meets(its, "wall") || meets(its, "its like") || meets(its, "half_space") ? " |" : cell("%g", its.size))
      << cell("%.3g", its.speed) << cell("%.4e", reference.value) << cell("%.1e", reference.error)
      << cell("%.4e", value.value) << cell("%.1e", value.error) << cell(off.padding ? "%.2f" : "%.2f u", off.ratio)
      << cell("%.1f", answer.cutoff) << '\n';
}

}  // namespace

bool write_modal(std::ostream& out) {
  std::cerr << "bodies by their modes\n";
  const std::vector<ModalPoint> points = read_modal();
  std::vector<Answer> answers;
  answers.reserve(points.size());
  for (const ModalPoint& point : points) answers.push_back(answer_to(point.its));
  out << text::modal_tally;
  for (const Share& share : shares()) {
    write_tally(out, share.name, quantity_names[lost_fraction], tally_of(points, answers, share, lost_fraction));
  }
  for (const Quantity quantity : {contact_time, impulse_time, max_force, max_compression}) {
    write_tally(out, "all", quantity_names[quantity], tally_of(points, answers, shares().front(), quantity));
  }
  const bool all_honest = honest(tally_of(points, answers, shares().front(), lost_fraction));
  out << "\nThe conditions are" << (all_honest ? " met.\n" : " **not met**.\n") << text::modal_points;
  for (std::size_t i = 0; i < points.size(); ++i) write_point(out, points[i], answers[i]);
  return all_honest;
}

}  // namespace validate
