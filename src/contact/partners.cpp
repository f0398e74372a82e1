// Which bodies can meet.
#include <cmath>
#include <string>

#include "check.hpp"
#include "contact/units.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

void require_ratio(const std::string& name, double ratio) {
  constexpr double rounding = 1e-9;
  constexpr Range allowed{1e-3 * (1.0 - rounding), 1e3 * (1.0 + rounding), true, true, "0.001 to 1000"};
  require(name + " ratio", ratio, allowed, "of the second body to the first");
}

}  // namespace

void require_partners(const Body& first, const Body& second) {
  if (first.contour != second.contour) {
    throw InvalidInput("against: got '" + second.name + "' for '" + first.name +
                       "', allowed a body of the same kind of end (a disk meets disks, a sphere spheres, a rod rods)");
  }
  const Units units(second, first);
  require_ratio(first.contour == Contour::flat ? "length" : "radius", units.length);
  if (first.contour == Contour::flat) {
    require_ratio("transit time", units.time);
    require_ratio("impedance", units.impedance);
  } else {
    const double volume = units.length * units.length * (first.contour == Contour::ball ? units.length : 1.0);
    require_ratio("young", 1.0 / units.softness);
    require_ratio("density", units.mass / volume);
  }
  constexpr double rounding = 1e-9;
  const double cutoff = second.cutoff / units.time;
  if (std::abs(cutoff - first.cutoff) > rounding * first.cutoff) {
    throw InvalidInput("cutoff: got " + std::to_string(first.cutoff) + " for the first body and " +
                       std::to_string(cutoff) +
                       " for the second, allowed one frequency for both (in c/R of the first)");
  }
}

}  // namespace stoss
