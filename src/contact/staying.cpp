#include "contact/staying.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/unit_ratios.hpp"
#include "contact/zener.hpp"

namespace stoss {
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
  if (!contact.gives_way || !(contact.second->part.mobility > 0.0)) return false;
  const UnitRatios units = units_of(contact, 1);
  // κ = √(D/ρh), as giving over mobility is 4√(κ/2π), whether of a plate or of a strip of it.
  const double over = contact.second->part.giving / (4.0 * contact.second->part.mobility);
  const double spreading = 2.0 * std::numbers::pi * over * over * units.length * units.length / units.time;
  return spreading < of_speed * speed && spreading * time < of_ball &&
         zener_scales(contact, speed).inelasticity > surely;
}

std::optional<double> rebound_of_staying(const Contact& contact, double speed, const Slowing& before,
                                         const Slowing& now) {
  if (!contact.gives_way || (!now.touches && now.velocity < 0.0)) return std::nullopt;
  const bool ball = contact.second->part.mobility > 0.0;
  return ball ? on_a_plate(contact, speed, before, now) : on_a_strip(contact, speed, before, now);
}

}  // namespace stoss
