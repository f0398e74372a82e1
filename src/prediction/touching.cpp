#include "prediction/touching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "check.hpp"
#include "encounter/participant.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic/adhesion.hpp"
#include "stoss/quasistatic/yield.hpp"

namespace stoss::prediction {
namespace {

using std::numbers::pi;

/// What one of the two adds.
struct Side {
  double curvature = 0.0, softness = 0.0, inverse_mass = 0.0;
  std::optional<double> yield_strength{}, surface_energy{};
};

Side side_of(const Participant& of, std::optional<double> frequency) {
  Side side;
  const Material& material = *of.material;
  const double radius = given_or(of, "radius", std::numeric_limits<double>::infinity());
  side.curvature = 1.0 / radius;
  side.inverse_mass = 3.0 / (4.0 * pi * material.density) * std::pow(side.curvature, 3);
  side.surface_energy = material.surface_energy;
  side.softness = softness_of(of) / stiffer(losses_of(of), frequency.value_or(losses_of(of).frequency));
  if (!of.rigid) side.yield_strength = material.yield_strength;
  return side;
}

std::optional<double> weaker(const std::optional<double>& one, const std::optional<double>& other) {
  if (one && other) return std::min(*one, *other);
  return one ? one : other;
}

double work_between(const Side& one, const Side& other) {
  if (!one.surface_energy || !other.surface_energy) return 0.0;
  return 2.0 * std::sqrt(*one.surface_energy * *other.surface_energy);
}

}  // namespace

double stiffer(const Losses& its, double frequency) {
  if (!its.relaxation.terms.empty()) return std::abs(modulus(its.relaxation, {0.0, frequency}));
  if (its.quality == 0.0) return 1.0;
  return std::pow(frequency / its.frequency, 2.0 / pi * std::atan(1.0 / its.quality));
}

double Touching::time(double speed) const {
  const double stiffness = 4.0 / (3.0 * pair.softness * std::sqrt(pair.curvature));
  return std::pow(mass / stiffness, 0.4) * std::pow(speed, -0.2);
}

double Touching::radius_ratio(double speed) const {
  return std::sqrt(std::pow(1.25, 0.4) * speed * time(speed) * pair.curvature);
}

double Touching::speed_of_compression(double length) const {
  return std::pow(length / (std::pow(1.25, 0.4) * time(1.0)), 1.25);
}

double Touching::tabor_number() const {
  constexpr double range = 3e-10;  // z₀, m
  const double ratio = work_of_adhesion * pair.softness / range;
  return std::cbrt(ratio * ratio / (pair.curvature * range));
}

quasistatic::InelasticContact Touching::contact(double speed) const {
  quasistatic::InelasticContact made;
  const double length = speed * time(speed);
  if (yield_speed) made.yield_depth = std::pow(1.25, 0.4) * std::pow(*yield_speed / speed, 0.8);
  const double square = 2.0 * pi * work_of_adhesion * pair.softness * pair.curvature;  // κ²
  made.adhesion = std::pow(square, 2.0 / 3.0) / (pair.curvature * length);
  return made;
}

double speed_of_impression(const Touching& touching) {
  using quasistatic::YieldLaw;
  constexpr double wide = 0.2;
  const double onset = touching.radius_ratio(*touching.yield_speed);
  if (onset >= wide) return *touching.yield_speed;
  double low = 1.0, high = 1e6;  // of d
  for (int i = 0; i < 60; ++i) {
    const double depth = std::sqrt(low * high);
    (onset * loading_radius(YieldLaw::finite_elements, depth) < wide ? low : high) = depth;
  }
  return *touching.yield_speed * std::sqrt(2.5 * loading_work(YieldLaw::finite_elements, low));
}

Touching touching(const Encounter& encounter, std::optional<double> work_of_adhesion, std::optional<double> frequency) {
  validate(encounter);
  const Participant& ball = encounter.first;
  const Participant& met = encounter.against;
  if (ball.kind != "sphere") {
    throw InvalidInput::out_of_range("body", "a " + ball.kind, "a sphere", "yield and adhesion are models of balls");
  }
  if (!ball.material)
    throw InvalidInput::missing("material", "", "the ball needs one, and so does what it meets, in SI");
  if (met.kind == "exponential" || met.modal) {
    throw InvalidInput::out_of_range("against", met.kind, "wall, same, sphere, half-space or plate");
  }
  const Side one = side_of(ball, frequency);
  Side other;
  if (met.kind == "same") other = one;
  if (met.kind == "wall") other.surface_energy = one.surface_energy;
  if (met.material) other = side_of(met, frequency);
  Touching made;
  made.pair = {one.curvature + other.curvature, one.softness + other.softness};
  made.mass = 1.0 / (one.inverse_mass + other.inverse_mass);
  if (const auto strength = weaker(one.yield_strength, other.yield_strength)) {
    made.yield_speed = quasistatic::yield_speed(made.pair, made.mass, *strength);
  }
  made.work_of_adhesion = work_of_adhesion.value_or(work_between(one, other));
  require("adhesion", made.work_of_adhesion, ranges::adhesion, "work of adhesion in J/m^2");
  made.sheet = met.kind == "plate";
  return made;
}

namespace {

using quasistatic::InelasticContact;
using quasistatic::InelasticImpact;

/// Losses follow these numbers like powers between 0 and 1: their ratio to what is asked for leads to it.
double improved(double number, double asked, double got) {
  constexpr double most_change = 4.0, largest = 1e3, least = 1e-300;
  return std::min(number * std::clamp(asked / std::max(got, least), 1.0 / most_change, most_change), largest);
}

/// The motion in which waves take that share.
InelasticContact radiating(double share, Waves form) {
  constexpr double accuracy = 1e-8, rounding = 1e-10;
  constexpr int most_rounds = 60;
  InelasticContact made;
  if (share <= 0.0) return made;
  double& number = form == Waves::of_force ? made.mobility : made.radiation;
  number = share / 3.0;  // first order
  for (int i = 0; i < most_rounds; ++i) {
    const double got = inelastic_impact(made).waves;
    if (std::abs(got - share) <= accuracy * share + rounding) break;
    number = improved(number, share, got);
  }
  return made;
}

}  // namespace

WavyImpact::WavyImpact(const Computed& computed, Waves form)
    : computed_(computed), contact_(radiating(std::max(computed.waves(), 0.0), form)) {
  const InelasticImpact alone = inelastic_impact(contact_);
  const double left = 1.0 - alone.waves;
  returned_ = left > 0.0 ? std::min(computed.restitution * computed.restitution / left, 1.0) : 0.0;
  time_ = alone.contact_time;
}

PredictedImpact WavyImpact::with(const Touching& touching, double speed, quasistatic::YieldLaw law) const {
  InelasticContact all = touching.contact(speed);
  all.yield_law = law;
  all.radiation = contact_.radiation, all.mobility = contact_.mobility;
  InelasticImpact together = inelastic_impact(all);
  const double time = together.contact_time;
  const auto returned = [&] { return (1.0 - together.waves - together.yield) * returned_; };
  const bool sticks = together.sticks || returned() <= together.adhesion;
  if (together.sticks) {  // adhesion has what they would have left with
    all.adhesion = 0.0;
    together = inelastic_impact(all);
  }
  const double stored = 1.0 - together.waves - together.yield;
  const double ringing = computed_.waves() > 0.0 ? computed_.ringing / computed_.waves() : 0.0;
  PredictedImpact made;
  made.time = sticks ? std::numeric_limits<double>::infinity() : computed_.time * time / time_;
  const double adhesion = sticks ? returned() : together.adhesion;
  made.restitution = sticks ? 0.0 : std::sqrt(returned() - adhesion);
  made.shares = {together.waves * ringing, together.waves * (1.0 - ringing), stored * (1.0 - returned_),
                 std::max(together.yield, 0.0), adhesion};
  return made;
}

}  // namespace stoss::prediction
