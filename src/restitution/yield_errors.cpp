#include "restitution/yield_errors.hpp"

#include <algorithm>
#include <cmath>

#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "restitution/calibration.hpp"

namespace stoss {
namespace {

double width_of(const Contact& contact, const Impact& finest) { return finest.max_half_width / contact.radius; }

/// What rings in bounded bodies, and what runs away in a half-space or plate.
struct Waves {
  double ring = 0.0, run = 0.0;
};

Waves waves(const Contact& contact, const Impact& impact) {
  Waves its;
  for (const ModeEnergy& mode : impact.energy.modes) {
    (contact.unbounded && mode.body == 1 ? its.run : its.ring) += std::abs(mode.after - mode.before);
  }
  return its;
}

/// 4s(1 − s) of the share s of an elastic body in the compression, where the other yields: its law is exact beside a
/// rigid body, and of two alike.
double elastic_partner(const Contact& contact) {
  const auto strength_of = [&](int number) {
    const auto body = body_of(contact, number);
    return body == nullptr ? 0.0 : body->strength.yield * units_of(contact, number).stress;
  };
  constexpr double alike = 1.0 + 1e-6;
  const double one = strength_of(0), other = strength_of(1);
  if (contact.second == nullptr || (one > 0.0 && other > 0.0 && std::max(one, other) <= alike * std::min(one, other)))
    return 0.0;
  const double first = contact.first->softness / touch(contact).softness;
  return 4.0 * first * (1.0 - first);
}

}  // namespace

double doubt_of_yield(const Contact& contact, const Impact& finest) {
  using namespace calibration;
  if (contact.yield.yield == 0.0) return 0.0;
  const auto [ring, run] = waves(contact, finest);
  const double place = place_of_ringing * ring + place_of_radiation * sensitivity(contact, run);
  const double flow = std::min(std::max(0.0, 1.0 - finest.lost_fraction), finest.energy.yielded);
  return width_of(contact, finest) * place + (law_of_yield + law_of_one * elastic_partner(contact)) * flow;
}

Term yield_error_of_force(const Contact& contact, const Restitution& result, double value) {
  if (contact.yield.yield == 0.0) return {};
  const bool plate = contact.keeps_displacement;
  const double share = plate ? calibration::on_a_plate : calibration::force_at_a_place;
  return {plate ? "on_a_plate" : "force_at_a_place", share, share * width_of(contact, result.finest) * std::abs(value)};
}

Term yield_error_of_time(const Contact& contact, const Restitution& result, double value) {
  if (contact.yield.yield == 0.0) return {};
  constexpr double share = calibration::time_at_a_place;
  const double width = width_of(contact, result.finest);
  return {"time_at_a_place", share, share * width * width * std::abs(value)};
}

}  // namespace stoss
