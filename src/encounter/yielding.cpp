// From which speed a sphere, or what it meets, yields, and what is said of elastic results beyond it.
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "encounter/participant.hpp"
#include "encounter/shells.hpp"
#include "encounter/yielding.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/kinds.hpp"
#include "stoss/quasistatic/yield.hpp"

namespace stoss {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Which of the two yields first.
std::string weaker_of(const Encounter& encounter) {
  const std::string& met = encounter.against.kind;
  if (strength_of(encounter.first).value_or(unlimited) <= strength_of(encounter.against).value_or(unlimited))
    return encounter.first.modal ? "body" : "ball";
  return encounter.against.modal                     ? "body"
         : met == "sphere" || met == "hollow-sphere" ? "other ball"
         : met == "half-space"                       ? "block"
                                                     : met;
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

/// √(m of the solids alone / m with what is fixed to them): a slower blow of a heavier ball has the same energy.
double slower_by_extra_mass(const Encounter& encounter) {
  const auto sum = [&](const auto& inverse) {
    const bool wall = kind(encounter.against.kind).wall && encounter.against.kind != "same";
    const Participant& second = encounter.against.kind == "same" ? encounter.first : encounter.against;
    return inverse(encounter.first) + (wall ? 0.0 : inverse(second));
  };
  return std::sqrt(sum(inverse_mass_of) / sum(inverse_mass_of_solid));
}

/// Of the solids alone.
std::optional<double> yield_speed_of_solids(const Encounter& encounter) {
  const Participant& first = encounter.first;
  if (!first.material || !kind(first.kind).can_yield) return std::nullopt;
  const double radius = given_or(first, "radius", unlimited);
  Material material = *first.material;
  material.yield_strength = strength_of(first);
  if (first.rigid) material.young = unlimited;
  if (encounter.against.kind == "same") return quasistatic::yield_speed(material, radius, material, radius);
  if (kind(encounter.against.kind).wall) return quasistatic::yield_speed(material, radius);
  if (!kind(encounter.against.kind).can_yield) return std::nullopt;
  return with_prefix_against([&] {
    Material other = *encounter.against.material;
    other.yield_strength = strength_of(encounter.against);
    if (encounter.against.rigid) other.young = unlimited;
    return quasistatic::yield_speed(material, radius, other, given_or(encounter.against, "radius", unlimited));
  });
}

}  // namespace

std::optional<double> strength_of(const Participant& of) {
  if (of.rigid) return std::nullopt;
  if (const double given = given_or(of, "yield_strength", 0.0); given > 0.0) return given;
  return of.material ? of.material->yield_strength : std::nullopt;
}

std::optional<double> yield_speed(const Encounter& encounter) {
  if (has_shell(encounter) || encounter.first.modal || encounter.against.modal) {
    const auto may = [](const Participant& of) { return of.modal || kind(of.kind).can_yield; };
    const bool known = encounter.first.material && may(encounter.first) &&
                       (kind(encounter.against.kind).wall || may(encounter.against));
    return known ? yield_speed_with_shells(encounter) : std::nullopt;
  }
  const auto of_solids = yield_speed_of_solids(encounter);
  return of_solids ? std::optional(*of_solids * slower_by_extra_mass(encounter)) : std::nullopt;
}

BodyMaker yielding_as_given(const BodyMaker& maker, const Encounter& encounter, const Participant& of) {
  const double given = given_or(of, "yield_strength", 0.0), rate = given_or(of, "yield_rate", 0.0);
  const double hardening = given_or(of, "yield_hardening", 0.0);
  if (given == 0.0) {
    if (rate > 0.0) throw InvalidInput::missing("yield_strength", "", "there is a yield_rate");
    if (hardening > 0.0) throw InvalidInput::missing("yield_strength", "", "there is a yield_hardening");
    return maker;
  }
  const double young = of.modal ? of.modal->young : all_values(of, 0.0, size_of_first(encounter)).at("young");
  const Strength strength{given / young, hardening / young, rate};
  if (rate == 0.0) return yielding(maker, strength);
  const auto scales = si_scales(encounter);
  if (!scales) {
    throw InvalidInput::conflict("yield_rate", "without a material", "rates of strain are in 1/s, and need SI");
  }
  return [maker, strength, second = scales->time](double cutoff, const Poll& poll) {
    const Body body = maker(cutoff, poll);
    return yielding(body,
                    {strength.yield, strength.hardening, strength.rate, second * body.scale.length / body.scale.speed});
  };
}

bool yields(const Encounter& encounter) {
  return given_or(encounter.first, "yield_strength", 0.0) > 0.0 ||
         given_or(encounter.against, "yield_strength", 0.0) > 0.0;
}

std::string yield_warning(const Encounter& encounter, double speed) {
  return yield_warning(encounter, speed, "you asked for");
}

std::string yield_warning(const Encounter& encounter, double speed, const std::string& whose) {
  const std::optional<double> onset = yield_speed(encounter);
  if (yields(encounter) || !onset || speed <= *onset) return {};
  constexpr double well_beyond = 3.0;  // there yielding takes a tenth of the energy and more
  const double ratio = speed / *onset;
  return "the " + weaker_of(encounter) + " yields above " + rounded_to(3, *onset) + " m/s (" + whose + " " +
         rounded_to(4, speed) + " m/s, " + times(ratio) + " times that): the real rebound is " +
         (ratio > well_beyond ? "much " : "") + "lower; give a yield_strength, or use stoss predict";
}

std::vector<std::string> material_warnings(const Encounter& encounter, double fastest) {
  std::vector<std::string> all = shell_warnings(encounter, fastest);
  for (std::string& line : sound_warnings(encounter)) all.push_back(std::move(line));
  if (std::string line = yield_warning(encounter, fastest); !line.empty()) all.insert(all.begin(), std::move(line));
  return all;
}

}  // namespace stoss
