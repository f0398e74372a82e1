// By how much a named material, which has Q at one frequency as a Kelvin-Voigt body, loses too much or too little, and
// what is said of it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "encounter/participant.hpp"
#include "quasistatic/lossy_motion.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/kinds.hpp"

namespace stoss {
namespace {

using std::numbers::pi;

/// Duration of Hertz' impact, (m/k)^{2/5} v^{−1/5}.
constexpr double hertz_duration = 3.218;

/// A material that loses too much or too little.
struct Misfit {
  const NamedMaterial* material = nullptr;
  double speed = 0.0;      ///< m/s
  double factor = 1.0;     ///< loss as computed over that of one quality at all frequencies
  double change = 0.0;     ///< of 1 − ε²
  double frequency = 0.0;  ///< of the contact, Hz
  double loss_time = 0.0;  ///< that loses as much, s
};

double radius_of(const Participant& of) { return given_or(of, "radius", std::numeric_limits<double>::infinity()); }

double sphere_mass(const Participant& of) { return 4.0 / 3.0 * pi * of.material->density * std::pow(radius_of(of), 3); }

bool has_second_material(const Encounter& encounter) { return encounter.against.material.has_value(); }

/// Of both bodies: reduced, kg, of spheres and what does not move.
double reduced_mass(const Encounter& encounter) {
  const double mass = sphere_mass(encounter.first);
  if (encounter.against.kind == "same") return 0.5 * mass;
  if (encounter.against.kind != "sphere") return mass;
  return mass / (1.0 + mass / sphere_mass(encounter.against));
}

double softness(const Encounter& encounter) {
  const double its = softness_of(encounter.first);
  if (encounter.against.kind == "same") return 2.0 * its;
  return its + (has_second_material(encounter) ? softness_of(encounter.against) : 0.0);
}

/// About how long the two touch, s: Hertz' contact of spheres, the estimate of others that set the grid, twice the
/// passage of a wave of rods.
double contact_time(const Encounter& encounter, double speed) {
  const Participant& first = encounter.first;
  const Participant& met = encounter.against;
  if (first.kind == "rod") {
    const auto passage = [](const Participant& rod) {
      return given_or(rod, "length", 1.0) * std::sqrt(rod.material->density / rod.material->young);
    };
    return 2.0 * (met.kind == "rod" ? std::min(passage(first), passage(met)) : passage(first));
  }
  if (first.kind == "sphere" && met.kind != "modal") {
    const double curvature = 1.0 / radius_of(first);
    const double both = met.kind == "same" ? 2.0 * curvature : curvature + 1.0 / radius_of(met);
    const double stiffness = 4.0 / (3.0 * softness(encounter) * std::sqrt(both));
    return hertz_duration * std::pow(reduced_mass(encounter) / stiffness, 0.4) * std::pow(speed, -0.2);
  }
  const Scales its = si_scales(encounter).value();
  return expected_duration(refinable(encounter).at(0), std::clamp(speed / its.speed, 1e-8, 1.0)) * its.time;
}

/// 1 − ε² of what rings and radiates, to an order of magnitude: a force half a period of a sine long, on the impedance
/// of a plate, or on a block whose compliance of low frequencies radiates (docs/theory/half_space.md).
double waves(const Encounter& encounter, double speed, double time) {
  const double own = speed / si_scales(encounter)->speed;
  if (encounter.first.kind != "sphere") return own;
  const Participant& met = encounter.against;
  if (kind(met.kind).wall || kind(met.kind).bounded) return 0.25 * own;
  const Material& of = *met.material;
  const double mass = sphere_mass(encounter.first);
  const double shear_speed = std::sqrt(of.young / (2.0 * (1.0 + of.poisson) * of.density));
  const double block = 0.18 * std::pow(pi, 4) * mass / (of.density * std::pow(shear_speed * time, 3));
  const double thickness = given_or(met, "thickness", std::numeric_limits<double>::infinity());
  const double impedance = 2.31 * thickness * thickness * std::sqrt(of.young * of.density);
  return std::min(std::max(block, pi * pi * mass / (impedance * time)), 1.0);
}

/// 1 − ε² of a Kelvin–Voigt material, and x of it. @param time of contact
double loss_of(double number) {
  constexpr double most = 1e6;
  const double left = lossy_motion(quasistatic::LossyLaw::ting, std::min(number, most)).restitution;
  return 1.0 - left * left;
}

/// What the two lose too much or too little at that speed, as far as it matters.
std::vector<Misfit> misfits(const Encounter& encounter, double speed) {
  constexpr double tolerable = 1.5, noticeable = 0.1;
  const double time = contact_time(encounter, speed), unit = time / hertz_duration;
  std::vector<Misfit> all;
  double lost = waves(encounter, speed, time), off = 0.0;
  for (const Participant* each : {&encounter.first, &encounter.against}) {
    const NamedMaterial* its = named_of(*each);
    const double quality = quality_of(*each);
    if (its == nullptr || quality == 0.0 || each->rigid) continue;
    const double alone = softness_of(*each) * (encounter.against.kind == "same" ? 2.0 : 1.0);
    const double share = alone / softness(encounter);
    const double number = quasistatic::loss_number_of_quality(quality);
    const double right = loss_of(number), computed = loss_of(1.5 * *each->material->loss_time / unit);
    all.push_back({its, speed, computed / right, share * std::abs(computed - right), 0.5 / time, number / 1.5 * unit});
    lost += share * right, off += all.back().change;
  }
  std::erase_if(all, [&](const Misfit& each) {
    const double factor = std::max(each.factor, 1.0 / each.factor);
    return factor <= tolerable || off <= noticeable * lost || each.change <= 0.5 * noticeable * lost;
  });
  return all;
}

double worst(const std::vector<Misfit>& all) {
  double made = 0.0;
  for (const Misfit& each : all) made = std::max(made, std::abs(std::log(each.factor)));
  return made;
}

std::string two_digits(double number) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.*g", 2, number);
  if (number >= 100.0 && number < 1e6) (void)std::snprintf(text.data(), text.size(), "%.0f", number);
  return text.data();
}

std::string in_hertz(double frequency) {
  if (frequency >= 1e6) return two_digits(frequency / 1e6) + " MHz";
  return frequency >= 1e3 ? two_digits(frequency / 1e3) + " kHz" : two_digits(frequency) + " Hz";
}

}  // namespace

std::vector<std::string> loss_warnings(const Encounter& encounter, double slowest, double fastest) {
  if (!encounter.first.material || !(slowest > 0.0)) return {};
  if (quality_of(encounter.first) == 0.0 && quality_of(encounter.against) == 0.0) return {};
  std::vector<Misfit> found = misfits(encounter, slowest);
  if (fastest > slowest) {
    if (std::vector<Misfit> other = misfits(encounter, fastest); worst(other) > worst(found)) found = std::move(other);
  }
  std::vector<std::string> lines;
  for (const Misfit& each : found) {
    if (!lines.empty() && each.material == found.front().material) continue;
    const bool more = each.factor > 1.0;
    lines.push_back("the loss of " + std::string(each.material->name) + " is " +
                    two_digits(more ? each.factor : 1.0 / each.factor) + " times too " + (more ? "large" : "small") +
                    " at " + two_digits(each.speed) + " m/s: its loss time is for " +
                    in_hertz(each.material->frequency / (2.0 * pi)) + ", this contact has " + in_hertz(each.frequency) +
                    "; " + (encounter.first.kind == "sphere" ? "use stoss predict, or" : "give") + " a loss time of " +
                    two_digits(each.loss_time) + " s");
  }
  return lines;
}

std::vector<std::string> sound_warnings(const Encounter& encounter) {
  std::vector<std::string> lines;
  for (const Participant* each : {&encounter.first, &encounter.against}) {
    const NamedMaterial* its = named_of(*each);
    if (its == nullptr || !its->sound || each->rigid || each->values.contains("loss_time")) continue;
    std::string line =
        std::string(its->name) +
        " is taken as sound, smooth, dry and uncracked: measured losses are often ten times as large and more";
    if (lines.empty() || lines.front() != line) lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<std::string> material_warnings(const Encounter& encounter, double slowest, double fastest) {
  std::vector<std::string> all;
  if (std::string line = yield_warning(encounter, fastest); !line.empty()) all.push_back(std::move(line));
  for (std::string& line : loss_warnings(encounter, slowest, fastest)) all.push_back(std::move(line));
  for (std::string& line : sound_warnings(encounter)) all.push_back(std::move(line));
  return all;
}

}  // namespace stoss
