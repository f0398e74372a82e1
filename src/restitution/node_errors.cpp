#include "restitution/node_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "restitution/calibration.hpp"
#include "restitution/face_errors.hpp"

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

Term node_error_of_losses(const Contact& contact, double speed, const Run& run) {
  if (!loses(contact) || contact.yield.yield > 0.0) return {};
  const bool circle = touch(contact).circle;
  const double constant = circle ? calibration::nodes_of_balls : calibration::nodes_on_a_line;
  const double nodes = run.resolution.nodes;
  return {circle ? "nodes_of_balls" : "nodes_on_a_line", constant,
          constant * run.dissipated / (nodes * nodes) * left_by_relaxing(contact, nodes, run.contact_time) *
              edge_left(contact, speed, run)};
}

}  // namespace stoss
