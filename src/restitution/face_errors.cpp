#include "restitution/face_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/edge/edge_law.hpp"
#include "contact/faces/coats.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/recommended.hpp"
#include "restitution/calibration.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {
namespace {

/// Whether anything lies between the faces, of contacts with more than one point.
bool covered(const Contact& contact) {
  return !has_single_point(contact) && (contact.asperities > 0.0 || coat_compliance(contact) > 0.0);
}

/// Whether a coat relaxes.
bool has_lossy_coat(const Contact& contact) {
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    if (body != nullptr && body->coat.compliance > 0.0 && !body->coat.relaxation.terms.empty()) return true;
  }
  return false;
}

double left_on(const Contact& contact, double speed, double half_width, int nodes) {
  if (contact.asperities == 0.0) return 1.0;
  return edge_left(contact, contact_grid(contact, half_width, nodes), speed);
}

/// Error of what is lost, relative to it: those of edges fall with n², and as far as asperities smear them out; that of
/// the pressure of asperities, which is smooth, with h⁴. On a half-space all that is heard of a pulse is its length.
Term lost_by_nodes(const Contact& contact, double speed, double half_width, int nodes, double heat) {
  using namespace calibration;
  const auto here = [&](const OnFaces& constant) { return contact.unbounded ? constant.on_waves : constant.at_walls; };
  const double n = nodes, edge = left_on(contact, speed, half_width, nodes) / (n * n);
  const double length = coat_compliance(contact) / touch(contact).softness;
  const double width = expected_half_width(contact, speed), soft = length / (length + width);
  const double edges = here(nodes_of_edges), coats = here(nodes_of_coats);
  const bool bare_line = !touch(contact).circle && length == 0.0;
  const double pressure = here(bare_line ? nodes_of_asperities_on_a_line : nodes_of_asperities);
  const bool rough = contact.asperities > 0.0;
  const std::array<Term, 4> all{{
      {"nodes_of_edges", edges, rough ? edges * edge : 0.0},
      {"nodes_of_coats", coats, coats * std::sqrt(soft) * edge},
      {"nodes_of_lossy_coats", nodes_of_lossy_coats,
       has_lossy_coat(contact) ? nodes_of_lossy_coats * heat * edge : 0.0},
      {bare_line ? "nodes_of_asperities_on_a_line" : "nodes_of_asperities", pressure,
       rough ? pressure * std::pow(half_width / (width * n), 4) : 0.0},
  }};
  const auto less = [](const Term& a, const Term& b) { return a.error < b.error; };
  Term sum = *std::max_element(all.begin(), all.end(), less);
  sum.error = 0.0;
  for (const Term& each : all) sum.error += each.error;
  return sum;
}

}  // namespace

double edge_left(const Contact& contact, double speed, const Run& run) {
  return left_on(contact, speed, run.resolution.half_width, run.resolution.nodes);
}

bool leaves_edge(const Contact& contact, double speed) {
  constexpr double much = 0.1;
  if (contact.asperities == 0.0) return true;
  const Resolution first = refined_resolution(contact, speed, 0.0);
  return left_on(contact, speed, first.half_width.value(), first.nodes.value()) > much;
}

Term lost_error_of_faces(const Contact& contact, double speed, const Run& run) {
  if (!covered(contact)) return {};
  const double lost = std::abs(run.lost_fraction), heat = lost > 0.0 ? std::min(1.0, run.dissipated / lost) : 0.0;
  Term error = lost_by_nodes(contact, speed, run.resolution.half_width, run.resolution.nodes, heat);
  error.error *= lost;
  return error;
}

Term compression_error_of_faces(const Contact& contact, const Run& run) {
  using namespace calibration;
  if (!covered(contact)) return {};
  const Touch met = touch(contact);
  const double spacing = run.resolution.half_width / run.resolution.nodes, room = met.curvature * spacing * spacing;
  const double constant = met.circle ? spacing_of_balls : spacing_on_a_line;
  return {met.circle ? "spacing_of_balls" : "spacing_on_a_line", constant,
          constant * room / (1.0 + 0.5 * contact.asperities / room)};
}

Term pulse_error_of_faces(const Contact& contact, const Run& run, double quantity) {
  using calibration::nodes_of_pulse;
  if (!covered(contact)) return {};
  const double nodes = run.resolution.nodes;
  return {"nodes_of_pulse", nodes_of_pulse, nodes_of_pulse * std::abs(quantity) / (nodes * nodes)};
}

}  // namespace stoss
