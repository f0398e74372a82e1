#include "contact/edge/edge_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {
namespace {

// Constants of the law for which the force follows the envelope, to 2 % from 12 touching nodes on.
constexpr double force_constant = 0.7145;  // of two edges of unit length, those of a node and its mirror image
constexpr double gap_constant = 0.6177;
constexpr double least = 1e-6;  // that a law is scaled by
constexpr double outrun = 0.5;  // fit: the edge, which moves at v/(y/R), opens a smaller gap above the wave speed

/// What stands before √a s^{3/2}/R in the gap at a distance s from the edge of a Hertzian contact.
double opening_constant(bool circle) {
  const double line = 2.0 * std::numbers::sqrt2 / 3.0;
  return circle ? line * 4.0 / std::numbers::pi : line;
}

std::vector<EdgeLaw::Relaxing> relaxing_bodies(const Contact& contact, double softness) {
  std::vector<EdgeLaw::Relaxing> bodies;
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    if (body == nullptr || body->relaxation.terms.empty()) continue;
    const UnitRatios units = units_of(contact, number);
    bodies.push_back({body->softness * units.softness / softness, in_time(body->relaxation, units.time)});
  }
  return bodies;
}

}  // namespace

double EdgeLaw::energy_at(std::size_t i, double closure) const {
  const double t = std::clamp(closure, 0.0, 1.0);
  return full_force(i) * full_gap(i) * t * t * (1.0 - t * (4.0 / 3.0 - 0.5 * t));
}

double EdgeLaw::modulus_at(double time) const {
  double compliance = 1.0;
  for (const Relaxing& each : relaxing) {
    compliance += each.share * (1.0 / std::max(modulus_after(each.relaxation, time), least) - 1.0);
  }
  return 1.0 / compliance;
}

void EdgeLaw::follow(double before, double now, double half_width, double step) {
  // Half-widths go with the root of the compression, nearly so along a line; the last node to leave has one of ½.
  const double left = std::max(now, least * std::abs(before));
  const double rate = 0.5 * std::max(half_width, 0.5) * (now - before) / (left * step);  // of spacings
  if (rate >= 0.0) {
    shrinking = 0.0;
    opening = 1.0;
    firmness = rate > 0.0 ? modulus_at(1.0 / rate) : 1.0;
    return;
  }
  constexpr double constant = 24.0;
  const double passing = constant * loss_time * rate;
  shrinking += step;
  firmness = modulus_at(2.0 * shrinking);
  opening = std::max(least, std::min(1.0, firmness / modulus_at(-1.0 / rate)) / (1.0 + passing * passing));
}

double EdgeLaw::range(const std::vector<double>& recess) const {
  double range = 0.0;
  for (std::size_t i = 0; i < gap.size(); ++i) range = std::max(range, gap[i] - recess[i]);
  return range;
}

EdgeLaw edge_law(const Contact& contact, const ContactGrid& grid, double speed) {
  EdgeLaw law;
  if (has_single_point(contact)) return law;
  const Touch met = touch(contact);
  law.loss_time = met.loss_time;
  law.relaxing = relaxing_bodies(contact, met.softness);
  const double spacing = grid.points.spacing * grid.points.radius;
  const double constant = opening_constant(met.circle);
  for (std::size_t i = 0; i < grid.coordinate.size(); ++i) {
    const double at = grid.coordinate[i];
    const double mach = outrun * speed * met.slowness / (met.curvature * at);
    const double opening = constant * met.curvature * std::sqrt(at) / (1.0 + mach * mach);
    const double edges =
        met.circle ? std::numbers::pi * grid.points.radius * std::sin(grid.points.angle(i)) : 1.0;  // pairs
    law.force.push_back(force_constant * edges * opening * spacing * std::sqrt(spacing) / met.softness);
    law.gap.push_back(gap_constant * opening * spacing * std::sqrt(spacing));
  }
  return law;
}

}  // namespace stoss
