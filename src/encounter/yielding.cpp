// From which speed a sphere, or what it meets, yields, and what is said of elastic results beyond it.
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "encounter/participant.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/kinds.hpp"
#include "stoss/quasistatic/yield.hpp"

namespace stoss {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

double strength_of(const Participant& of) {
  return of.rigid || !of.material ? unlimited : of.material->yield_strength.value_or(unlimited);
}

/// Which of the two yields first.
std::string weaker_of(const Encounter& encounter) {
  const std::string& met = encounter.against.kind;
  if (strength_of(encounter.first) <= strength_of(encounter.against)) return "ball";
  return met == "sphere" ? "other ball" : met == "half-space" ? "block" : met;
}

std::string rounded_to(int digits, double number) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.*g", digits, number);
  return text.data();
}

/// 1.002, 3.64, 64, 5512
std::string times(double ratio) {
  return ratio < 1.1 ? rounded_to(4, ratio) : ratio < 10.0 ? rounded_to(3, ratio) : rounded_to(9, std::round(ratio));
}

}  // namespace

std::optional<double> yield_speed(const Encounter& encounter) {
  const Participant& first = encounter.first;
  if (!first.material || !kind(first.kind).can_yield) return std::nullopt;
  const double radius = given_or(first, "radius", unlimited);
  Material material = *first.material;
  if (first.rigid) material.young = unlimited;
  if (encounter.against.kind == "same") return quasistatic::yield_speed(material, radius, material, radius);
  if (kind(encounter.against.kind).wall) return quasistatic::yield_speed(material, radius);
  if (!kind(encounter.against.kind).can_yield) return std::nullopt;
  return with_prefix_against([&] {
    Material other = *encounter.against.material;
    if (encounter.against.rigid) other.young = unlimited;
    return quasistatic::yield_speed(material, radius, other, given_or(encounter.against, "radius", unlimited));
  });
}

std::string yield_warning(const Encounter& encounter, double speed) {
  const std::optional<double> onset = yield_speed(encounter);
  if (!onset || speed <= *onset) return {};
  constexpr double well_beyond = 3.0;  // there yielding takes a tenth of the energy and more
  const double ratio = speed / *onset;
  return "the " + weaker_of(encounter) + " yields above " + rounded_to(3, *onset) + " m/s (you asked for " +
         rounded_to(4, speed) + " m/s, " + times(ratio) + " times that): the real rebound is " +
         (ratio > well_beyond ? "much " : "") + "lower; use stoss predict";
}

std::vector<std::string> material_warnings(const Encounter& encounter, double fastest) {
  std::vector<std::string> all = sound_warnings(encounter);
  if (std::string line = yield_warning(encounter, fastest); !line.empty()) all.insert(all.begin(), std::move(line));
  return all;
}

}  // namespace stoss
