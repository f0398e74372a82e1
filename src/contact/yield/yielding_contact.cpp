#include "contact/yield/yielding_contact.hpp"

#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "contact/hard_contact.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Lateral distance where the last point's ring ends.
double radius_of(const ContactPoints& points) {
  return points.radius * std::sin(static_cast<double>(points.count) * points.spacing);
}

/// Share of each ring in the force of Hertz' pressure on a circle, √(b² − r²).
std::vector<double> hertzian_weights(const ContactPoints& points, double edge) {
  const auto outside = [&](std::size_t i) {
    const double at = points.radius * std::sin(static_cast<double>(i) * points.spacing) / edge;
    return std::pow(std::max(1.0 - at * at, 0.0), 1.5);
  };
  std::vector<double> weight(points.count);
  for (std::size_t i = 0; i < points.count; ++i) weight[i] = outside(i) - outside(i + 1);
  return weight;
}

/// What is left of the elasticity of the bodies, without that of half-spaces.
double remainder(const Contact& contact, const ContactGrid& grid, const std::vector<double>& weight, const Poll& poll) {
  const std::vector<double> compliance = residual_compliance(contact, grid, poll);
  const std::size_t n = weight.size();
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) sum += weight[i] * compliance[i * n + j] * weight[j];
  }
  return sum - 0.6 * touch(contact).softness / radius_of(grid.points);
}

/// Who yields: the weaker one, or both.
std::array<double, 2> shares_of_flow(const Contact& contact) {
  const auto yields = [&](int number) {
    const auto body = body_of(contact, number);
    if (body == nullptr || body->strength.yield == 0.0) return 0.0;
    constexpr double rounding = 1.0 + 1e-6;
    const double strength = body->strength.yield * units_of(contact, number).stress;
    return strength <= rounding * contact.yield.yield ? 1.0 : 0.0;
  };
  const double first = yields(0), second = yields(1);
  return {first / (first + second), second / (first + second)};
}

void require_computed(const Contact& contact, double speed) {
  Onset onset = onset_of(contact, speed);
  const double deepest = deepest_computed(contact.yield.hardening);
  if (onset.deepest <= deepest) return;
  double most = speed;  // a strength that grows with the rate of strain asks for some rounds
  for (int round = 0; round < 4; ++round, onset = onset_of(contact, most)) {
    most = std::sqrt(2.0 * onset.force * onset.depth * loading_work(deepest, contact.yield.hardening) /
                     contact.whole_mass);
  }
  throw InvalidInput::out_of_range("speed", shown(speed) + " c", "up to " + shown_most(most),
                                   "the contact would be pressed deeper than " + shown(deepest) +
                                       " times the depth at which it yields, where its law was not computed");
}

}  // namespace

YieldingContact::YieldingContact(const Contact& contact, const ContactGrid& grid, double speed, double step,
                                 const Poll& poll)
    : weight_(hertzian_weights(grid.points, radius_of(grid.points))),
      law_(contact, remainder(contact, grid, weight_, poll), speed, step),
      spacing_(grid.points.spacing * grid.points.radius),
      widest_(radius_of(grid.points) / 1.2),  // wider, the remainder leaves no stiffness
      first_kick_(first_kick(contact)),
      first_share_(loss_share(contact)),
      flows_(shares_of_flow(contact)),
      points_(grid.points),
      force_(weight_.size()),
      spread_(weight_.size()) {
  require_computed(contact, speed);
  for (std::size_t i = 0; i < weight_.size(); ++i) recess_ += weight_[i] * grid.recess[i];
}

const std::vector<double>& YieldingContact::advance(const std::vector<double>& position) {
  double place = recess_;
  for (std::size_t i = 0; i < weight_.size(); ++i) place += weight_[i] * position[i];
  law_.move(place);
  for (std::size_t i = 0; i < weight_.size(); ++i) force_[i] = weight_[i] * law_.force();
  return force_;
}

const std::vector<double>& YieldingContact::spread(const std::vector<double>& /*force*/) {
  if (law_.force() == 0.0) return force_;
  spread_ = hertzian_weights(points_, law_.radius());
  for (double& each : spread_) each *= law_.force();
  return spread_;
}

std::array<double, 2> YieldingContact::dissipated_energy() const {
  const double heat = law_.heat();
  return {first_share_ * heat, (1.0 - first_share_) * heat};
}

std::array<double, 2> YieldingContact::flow_energy() const {
  const double flow = law_.flow();
  return {flows_[0] * flow, flows_[1] * flow};
}

double YieldingContact::start(double stride) const { return start_before(first_kick_, 0.0, 0.0, stride); }

}  // namespace stoss
