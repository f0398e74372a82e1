// Where linear elasticity ends in the shell of a hollow sphere, and where it yields: a shell is a spring,
// k = 4Eh²/(R√(3(1−ν²))) under a force at a point (E. Reissner, J. Math. Phys. 25, 279 (1946)).
#include "encounter/shells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "check.hpp"
#include "stoss/quasistatic/yield.hpp"

namespace stoss {
namespace {

struct Shell {
  double stiffness, thickness;  // N/m, m
};

bool is_hollow(const Participant& of) { return of.kind == "hollow-sphere"; }

std::optional<Shell> shell_of(const Participant& of) {
  if (!is_hollow(of) || !of.material) return std::nullopt;
  const double radius = given_or(of, "radius", 1.0), thickness = radius * (1.0 - given_or(of, "inner", 0.0));
  const double poisson = of.material->poisson, bent = std::sqrt(3.0 * (1.0 - poisson * poisson));
  return Shell{4.0 * of.material->young * thickness * thickness / (radius * bent), thickness};
}

/// What is met, the first body again where it is its like.
const Participant& met_by(const Encounter& encounter) {
  return encounter.against.kind == "same" ? encounter.first : encounter.against;
}

double inverse_mass(const Participant& of) { return of.material ? inverse_mass_of(of) : 0.0; }

/// Of the shells of both, one after the other, m/N.
double shell_compliance(const Encounter& encounter) {
  double sum = 0.0;
  for (const Participant* each : {&encounter.first, &met_by(encounter)}) {
    if (const auto shell = shell_of(*each)) sum += 1.0 / shell->stiffness;
  }
  return sum;
}

/// Least force at which a shell yields as it bends, N.
double bending_force(const Encounter& encounter) {
  double force = std::numeric_limits<double>::infinity();
  for (const Participant* each : {&encounter.first, &met_by(encounter)}) {
    const auto shell = shell_of(*each);
    const auto its = strength_of(*each);
    if (shell && its) force = std::min(force, *its * shell->thickness * shell->thickness);
  }
  return force;
}

}  // namespace

double share_of_mass(const Participant& of) {
  return is_hollow(of) ? 1.0 - std::pow(given_or(of, "inner", 0.0), 3) : 1.0;
}

bool has_shell(const Encounter& encounter) { return is_hollow(encounter.first) || is_hollow(encounter.against); }

double yield_speed_with_shells(const Encounter& encounter, const quasistatic::PointPair& pair, double mass,
                               double strength) {
  const double local = quasistatic::yield_speed(pair, mass, strength);
  if (!has_shell(encounter)) return local;
  // Hertz: energy (8/15) s δ^(5/2) and force (4/3) s δ^(3/2), s = E*√R.
  const double energy = 0.5 * mass * local * local, stiff = 1.0 / (pair.softness * std::sqrt(pair.curvature));
  const double depth = std::pow(1.875 * energy / stiff, 0.4), onset = 2.5 * energy / depth;
  return std::sqrt((2.0 * energy + onset * onset * shell_compliance(encounter)) / mass);
}

std::optional<double> yield_speed_with_shells(const Encounter& encounter) {
  quasistatic::PointPair pair{0.0, 0.0};
  double inverse = 0.0, weakest = std::numeric_limits<double>::infinity();
  for (const Participant* each : {&encounter.first, &met_by(encounter)}) {
    if (kind(each->kind).wall) continue;
    if (each->modal) pair.curvature += each->modal->curvature;
    if (parameter(kind(each->kind), "radius") != nullptr) pair.curvature += 1.0 / given_or(*each, "radius", 1.0);
    pair.softness += softness_of(*each);
    inverse += inverse_mass(*each);
    weakest = std::min(weakest, strength_of(*each).value_or(weakest));
  }
  if (std::isinf(weakest) || pair.curvature == 0.0) return std::nullopt;
  return yield_speed_with_shells(encounter, pair, 1.0 / inverse, weakest);
}

std::optional<ShellLimit> shell_limit(const Encounter& encounter) {
  if (!has_shell(encounter) || !encounter.first.material) return std::nullopt;
  double force = std::numeric_limits<double>::infinity();
  for (const Participant* each : {&encounter.first, &met_by(encounter)}) {
    if (const auto shell = shell_of(*each)) force = std::min(force, shell->stiffness * shell->thickness);
  }
  const double inverse = inverse_mass(encounter.first) + inverse_mass(met_by(encounter));
  return ShellLimit{force, force * std::sqrt(shell_compliance(encounter) * inverse)};
}

std::vector<std::string> shell_warnings(const Encounter& encounter, double fastest) {
  const auto limit = shell_limit(encounter);
  if (!limit) return {};
  std::vector<std::string> lines;
  if (const double onset = bending_force(encounter) / limit->force * limit->speed; fastest > onset) {
    lines.push_back("bending, some F/h^2, reaches the yield strength of the shell from about " + rounded(onset, 3) +
                    " m/s on: no model here has that");
  }
  if (fastest <= limit->speed) return lines;
  std::string line = "the shell gives way by more than its thickness from about " + rounded(limit->speed, 3) +
                     " m/s on (" + rounded(limit->force, 3) + " N; you asked for " + rounded(fastest, 3) +
                     " m/s): linear elasticity ends there";
  if (fastest > buckling * limit->speed) {
    line += ", and it buckles inward from about " + rounded(buckling * limit->speed, 3) + " m/s on (" +
            rounded(buckling * limit->force, 3) + " N)";
  }
  lines.push_back(std::move(line));
  return lines;
}

}  // namespace stoss
