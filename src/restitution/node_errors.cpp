#include "restitution/node_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/faces/coats.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "restitution/calibration.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {
namespace {

/// Share of the error by nodes that is left where each of them relaxes while the edge passes it: n nodes in a time t,
/// 2 η n/t or some τ n/t of them in the time of relaxation. Each term counts as it loses in an impact.
double left_by_relaxing(const Contact& contact, double nodes, double duration) {
  using namespace calibration;
  const double loss_time = touch(contact).loss_time, viscous = 1.0 + 2.0 * loss_time * nodes / duration;
  double sum = 0.0, whole = 0.0;
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    if (body == nullptr) continue;
    const UnitRatios units = units_of(contact, number);
    for (const RelaxationTerm& term : body->relaxation.terms) {
      const double time = term.time * units.time, angle = std::numbers::pi * time / duration;
      const double loses = body->softness * units.softness * term.share * angle / (1.0 + angle * angle);
      const double passes = 1.0 + relaxing_nodes * time * nodes / duration;
      whole += loses;
      sum += loses * (always_left + (1.0 - always_left) / (passes * passes));
    }
  }
  return std::max(whole == 0.0 ? 0.0 : sum / whole, loss_time == 0.0 ? 0.0 : 1.0 / (viscous * viscous));
}

}  // namespace

Term node_error_of_losses(const Contact& contact, const Run& run) {
  if (!loses(contact) || contact.yield.yield > 0.0) return {};
  const bool circle = touch(contact).circle;
  const double constant = circle ? calibration::nodes_of_balls : calibration::nodes_on_a_line;
  const double nodes = run.resolution.nodes;
  return {circle ? "nodes_of_balls" : "nodes_on_a_line", constant,
          constant * run.dissipated / (nodes * nodes) * left_by_relaxing(contact, nodes, run.contact_time)};
}

Term node_error_of_faces(const Contact& contact, double speed, const Run& run) {
  using namespace calibration;
  const double nodes = run.resolution.nodes, of_lost = std::abs(run.lost_fraction) / (nodes * nodes);
  const double length = coat_compliance(contact) / touch(contact).softness;
  const double whole = length + expected_half_width(contact, speed);
  const double coats = length > 0.0 ? nodes_of_coats * std::sqrt(length / whole) : 0.0;
  const double asperities = contact.asperities > 0.0 ? nodes_of_asperities : 0.0;
  if (coats > asperities) return {"nodes_of_coats", nodes_of_coats, coats * of_lost};
  return {asperities > 0.0 ? "nodes_of_asperities" : "", nodes_of_asperities, asperities * of_lost};
}

}  // namespace stoss
