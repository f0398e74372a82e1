// With the force f = s^(3/2) as well as s: the ball moves at V = ṡ + λ f, V̇ = −f, and the plate at λ f.
#include "contact/zener.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"

namespace stoss {
namespace {

using Motion = std::array<double, 2>;  // s, V

Motion rate(const Motion& at, double inelasticity) {
  const double force = at[0] > 0.0 ? at[0] * std::sqrt(at[0]) : 0.0;
  return {at[1] - inelasticity * force, -force};
}

Motion moved(const Motion& at, const Motion& rate, double time) {
  return {at[0] + time * rate[0], at[1] + time * rate[1]};
}

}  // namespace

ZenerImpact zener_impact(double inelasticity, const ZenerMotion& start) {
  constexpr double usual_step = 2e-3, stays = 2e-5;
  constexpr double following = 0.03, room = 2.0;  // ṡ over V of a ball that follows its force, and for how long
  constexpr double rounding = 1e-12;              // of ṡ over V
  // A ball that follows its force has −ṡ/V = ⅔ λ^(−5/3) V^(−1/3): with this λ or more it does so until it stays.
  constexpr double follows_to_the_end = 20.0;
  // From s = 0 on, in the time in which the dashpot's force grows to the speed's.
  const double first_step = std::cbrt(0.04 / (inelasticity * inelasticity));
  double time = 0.0, followed = 0.0;
  Motion now{start.compression, start.speed};
  while (true) {
    // A stiff dashpot lets the compression follow the speed of the ball at once.
    const double stiff = 1.5 * inelasticity * std::sqrt(std::max(now[0], 0.0));
    const double step = std::min(usual_step * (1.0 + 0.2 * time), std::min(0.3 / stiff, first_step));
    const Motion first = rate(now, inelasticity), second = rate(moved(now, first, 0.5 * step), inelasticity);
    const Motion third = rate(moved(now, second, 0.5 * step), inelasticity);
    const Motion fourth = rate(moved(now, third, step), inelasticity);
    Motion next = now;
    for (std::size_t i = 0; i < next.size(); ++i) {
      next[i] += step / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]);
    }
    if (next[0] <= 0.0) {
      const double share = now[0] / (now[0] - next[0]);
      return {-(now[1] + share * (next[1] - now[1])), time + share * step};
    }
    const bool back = first[0] < rounding * now[1], slowly = -first[0] < following * now[1];
    if (followed == 0.0 && back && slowly) followed = room * time;
    now = next;
    time += step;
    if (followed > 0.0 && time > followed && inelasticity > follows_to_the_end) return {0.0, followed};
    const double potential = 0.8 * now[0] * now[0] * std::sqrt(now[0]);  // over the same ½mv² as V²
    if (now[1] * now[1] + potential < stays) return {0.0, followed > 0.0 ? std::min(followed, time) : time};
  }
}

ZenerScales zener_scales(const Contact& contact, double speed) {
  const Touch met = touch(contact);
  const double stiffness = 4.0 / (3.0 * met.softness * std::sqrt(met.curvature));
  const double time = std::pow(contact.whole_mass / (stiffness * std::sqrt(speed)), 0.4);
  const double mobility = contact.second->part.mobility / units_of(contact, 1).impedance;
  return {mobility * contact.whole_mass / time, time};
}

namespace {

constexpr double close = 0.25;        // of the law, to be moving by it
constexpr double hardly_any = 2e-5;   // of the energy
constexpr double least_known = 1e-3;  // of ε: what Zener leaves out is not measured below

/// eˣ erfc √x
double scaled_erfc(double x) {
  constexpr double large = 100.0;
  if (x > large) return (1.0 - 0.5 / x) / std::sqrt(std::numbers::pi * x);
  return std::exp(x) * std::erfc(std::sqrt(x));
}

std::optional<double> on_a_plate(const Contact& contact, double speed, const Slowing& before, const Slowing& now) {
  // Zener's ε at great λ, to 2 % from 2.5 on, and the least λ at which a ball is said to stay.
  constexpr double coefficient = 0.68, power = 5.0, least = 2.73;
  if (now.energy < hardly_any) return std::sqrt(now.energy);
  if (now.velocity <= 0.0) return std::nullopt;
  const auto [inelasticity, unit] = zener_scales(contact, speed);
  const double slower = before.velocity - now.velocity;
  const double by_law = 0.5 * (before.velocity + now.velocity) * (now.time - before.time) / (unit * inelasticity);
  const double off = std::abs(slower / by_law - 1.0);
  if (inelasticity < least || off > close) return std::nullopt;
  return std::max(least_known, coefficient / std::pow(inelasticity * (1.0 - off), power));
}

std::optional<double> on_a_strip(const Contact& contact, double speed, const Slowing& before, const Slowing& now) {
  if (now.velocity <= 0.0) return std::nullopt;
  const UnitRatios units = units_of(contact, 1);
  const double giving = contact.second->part.giving * std::sqrt(units.time) / units.mass;
  const double time = std::numbers::pi * std::pow(giving * contact.whole_mass, 2);
  const auto follows = [&](const Slowing& at) {
    const double by_law = speed * scaled_erfc(at.time / time);
    return std::abs(at.velocity - by_law) < close * by_law;
  };
  if (now.touches && !(follows(before) && follows(now))) return std::nullopt;
  return std::sqrt(hardly_any);
}

}  // namespace

bool stays_unseen(const Contact& contact, double speed, double time) {
  constexpr double surely = 20.0;                    // λ of a ball that is almost thrown back no more
  constexpr double of_speed = 0.55, of_ball = 0.35;  // of κ over vR, and of κt over R²
  if (!contact.keeps_displacement || !(contact.second->part.mobility > 0.0)) return false;
  const UnitRatios units = units_of(contact, 1);
  // κ = √(D/ρh), as giving over mobility is 4√(κ/2π), whether of a plate or of a strip of it.
  const double over = contact.second->part.giving / (4.0 * contact.second->part.mobility);
  const double spreading = 2.0 * std::numbers::pi * over * over * units.length * units.length / units.time;
  return spreading < of_speed * speed && spreading * time < of_ball &&
         zener_scales(contact, speed).inelasticity > surely;
}

std::optional<double> rebound_of_staying(const Contact& contact, double speed, const Slowing& before,
                                         const Slowing& now) {
  if (!contact.keeps_displacement || (!now.touches && now.velocity < 0.0)) return std::nullopt;
  const bool ball = contact.second->part.mobility > 0.0;
  return ball ? on_a_plate(contact, speed, before, now) : on_a_strip(contact, speed, before, now);
}

}  // namespace stoss
