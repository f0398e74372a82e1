// Hollow spheres are not computed here: with them the page would load later than it may. All spheres are solid.
#include "encounter/shells.hpp"
#include "bodies/sphere/hole/hole.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic/yield.hpp"

namespace stoss::bodies::sphere {

Hole::Hole(double, double inner) {
  if (inner == 0.0) return;
  throw InvalidInput::out_of_range("body", "a hollow sphere", "another body here", "the command and Python have it");
}

std::vector<Mode> Hole::modes(double poisson, double cutoff, const Poll& poll) const {
  return checked_modes(poisson, cutoff, poll);
}

std::vector<ToroidalMode> Hole::toroidal_modes(double poisson, double cutoff, const Poll& poll) const {
  return sphere::toroidal_modes(poisson, cutoff, poll);
}

const OrderExcess& Hole::excess(const Poll&) const {
  static const OrderExcess none;
  return none;
}

const Hole::Toroidal& Hole::toroidal_excess(const Poll&) const {
  static const Toroidal none;
  return none;
}

}  // namespace stoss::bodies::sphere

namespace stoss {

double share_of_mass(const Participant&) { return 1.0; }

bool has_shell(const Encounter&) { return false; }

double yield_speed_with_shells(const Encounter&, const quasistatic::PointPair& pair, double mass, double strength) {
  return quasistatic::yield_speed(pair, mass, strength);
}

std::optional<double> yield_speed_with_shells(const Encounter&) { return std::nullopt; }

std::optional<ShellLimit> shell_limit(const Encounter&) { return std::nullopt; }

std::vector<std::string> shell_warnings(const Encounter&, double) { return {}; }

}  // namespace stoss
