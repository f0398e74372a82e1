#include "prediction/touching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "check.hpp"
#include "encounter/participant.hpp"
#include "encounter/shells.hpp"
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
  side.curvature =
      of.modal ? of.modal->curvature : 1.0 / given_or(of, "radius", std::numeric_limits<double>::infinity());
  side.inverse_mass = inverse_mass_of(of);
  side.surface_energy = material.surface_energy;
  side.softness = softness_of(of) / stiffer(losses_of(of), frequency.value_or(losses_of(of).frequency));
  side.yield_strength = strength_of(of);
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

double least_work_of_jumps(double tabor_number) {
  constexpr std::array<std::pair<double, double>, 6> shares{
      {{0.7, 0.0}, {0.8, 0.005806}, {0.9, 0.019074}, {1.0, 0.034944}, {2.0, 0.204270}, {3.0, 0.319877}}};
  if (tabor_number <= shares.front().first) return 0.0;
  const auto [last, share] = shares.back();
  constexpr double power = 0.71;  // of what is missing, from 3 to 5, of the study's own law
  if (tabor_number >= last) return 1.0 - (1.0 - share) * std::pow(last / tabor_number, power);
  std::size_t i = 1;
  while (shares[i].first < tabor_number) ++i;
  const auto [low, below] = shares[i - 1];
  const auto [high, above] = shares[i];
  return below + (above - below) * (tabor_number - low) / (high - low);
}

double Touching::adhesion(double compression) const {
  quasistatic::PointPair left = pair;
  if (yield_strength) {
    const double strain = 0.5 * pi * yield_pressure_ratio * *yield_strength * pair.softness;
    left.curvature /= unloading(compression * pair.curvature / (strain * strain)).radius_ratio;
  }
  return quasistatic::adhesion_energy(left, work_of_adhesion);
}

double speed_of_impression(const Touching& touching) {
  constexpr double wide = 0.2;
  const double onset = touching.radius_ratio(*touching.yield_speed);
  if (onset >= wide) return *touching.yield_speed;
  double low = 1.0, high = 1e6;  // of d
  for (int i = 0; i < 60; ++i) {
    const double depth = std::sqrt(low * high);
    (onset * loading_radius(depth) < wide ? low : high) = depth;
  }
  return *touching.yield_speed * std::sqrt(2.5 * loading_work(low));
}

Touching touching(const Encounter& encounter, std::optional<double> work_of_adhesion, std::optional<double> frequency) {
  validate(encounter);
  const Participant& ball = encounter.first;
  const Participant& met = encounter.against;
  if (ball.kind != "sphere" && ball.kind != "hollow-sphere" && !ball.modal) {
    throw InvalidInput::out_of_range("body", "a " + ball.kind, "a sphere, a hollow-sphere, or a body by its modes",
                                     "yield and adhesion are models of what touches on a circle");
  }
  if (!ball.material)
    throw InvalidInput::missing("material", "", "the ball needs one, and so does what it meets, in SI");
  if (met.kind == "exponential") {
    throw InvalidInput::out_of_range("against", met.kind,
                                     "wall, same, sphere, hollow-sphere, half-space, plate or modal");
  }
  const Side one = side_of(ball, frequency);
  Side other;
  if (met.kind == "same") other = one;
  if (met.kind == "wall") other.surface_energy = one.surface_energy;
  if (met.material) other = side_of(met, frequency);
  Touching made;
  made.pair = {one.curvature + other.curvature, one.softness + other.softness};
  if (made.pair.curvature == 0.0) (void)refinable(encounter);  // refuses flat faces
  made.mass = 1.0 / (one.inverse_mass + other.inverse_mass);
  if (const auto strength = weaker(one.yield_strength, other.yield_strength)) {
    made.yield_strength = strength;
    made.yield_speed = yield_speed_with_shells(encounter, made.pair, made.mass, *strength);
  }
  made.work_of_adhesion = work_of_adhesion.value_or(work_between(one, other));
  require("adhesion", made.work_of_adhesion, ranges::adhesion, "work of adhesion in J/m^2");
  return made;
}

}  // namespace stoss::prediction
