#include "contact/unit_ratios.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double unequal = 1e-9;

void require_ratio(const std::string& name, double ratio) {
  constexpr Range allowed{1e-3 * (1.0 - unequal), 1e3 * (1.0 + unequal), true, true, "0.001 to 1000"};
  require(name + " ratio", ratio, allowed, "of the second body to the first");
}

void require_ratio_of_half_space(const std::string& name, double ratio) {
  constexpr Range allowed{1e-3 * (1.0 - unequal), 1e6 * (1.0 + unequal), true, true, "0.001 to 1e6"};
  require(name + " ratio", ratio, allowed, "of the half-space to the body");
}

void require_contours(const Body& first, const Body& second) {
  if (first.contour == second.contour) return;
  throw InvalidInput("against: got '" + second.name + "' for '" + first.name +
                     "', allowed a body of the same kind of end (a disk meets disks and half-planes, a sphere spheres "
                     "and half-spaces, a rod rods)");
}

/// Refuses a contact that is far from a circle. @param other curvature of what the body meets, in its units
void require_round(const Body& body, double other) {
  constexpr double most = 4.0;
  const double mean = body.curvature + other, half = 0.5 * body.curvature_difference;
  if (mean > half && mean + half <= most * (mean - half)) return;
  throw InvalidInput("curvature: got principal curvatures of '" + body.name +
                     "' that make a long contact with what it meets, allowed relative ones up to 4 : 1");
}

}  // namespace

UnitRatios units_of(const Contact& contact, int number) {
  return number == 0 ? UnitRatios{} : UnitRatios(*contact.second, *contact.first);
}

ContactPoints seen_by(const ContactPoints& points, const UnitRatios& units) {
  return {points.radius / units.length, points.spacing, points.count};
}

std::size_t shape_rows(const Body& body) {
  std::size_t rows = 0;
  for (const ModeGroup& group : body.groups) rows = std::max({rows, group.upper_row + 1, group.lower_row + 1});
  return rows;
}

void require_partners(const Body& first, const Body& second) {
  require_contours(first, second);
  if (is_unbounded(first)) {
    throw InvalidInput("against: got '" + first.name + "' as the first body, allowed one that moves");
  }
  if (first.softness == 0.0 && second.softness == 0.0) {
    throw InvalidInput("rigid: got two rigid bodies, allowed one (the other must deform)");
  }
  if (first.contour == Contour::ball && first.curvature + second.curvature == 0.0) {
    throw InvalidInput("curvature: got a plane surface of '" + first.name + "' and of '" + second.name +
                       "', allowed one (they would touch all over)");
  }
  const UnitRatios units(second, first);
  if (first.curvature_difference > 0.0) require_round(first, second.curvature / units.length);
  if (second.curvature_difference > 0.0) require_round(second, first.curvature * units.length);
  if (is_unbounded(second) && is_known_at_a_point(first)) {
    require_ratio_of_half_space("young", 1.0 / units.softness);
  } else if (is_unbounded(second)) {
    const double size = first.contour == Contour::ball ? units.length : 1.0;
    require_ratio_of_half_space("young", 1.0 / units.softness);
    require_ratio_of_half_space("density", units.mass / (units.length * units.length * size));
  } else if (first.contour == Contour::flat) {
    require_ratio("length", units.length);
    require_ratio("transit time", units.time);
    require_ratio("impedance", units.impedance);
  } else if (!is_known_at_a_point(first) && !is_known_at_a_point(second)) {
    require_ratio("radius", units.length);
    const double volume = units.length * units.length * (first.contour == Contour::ball ? units.length : 1.0);
    require_ratio("young", 1.0 / units.softness);
    require_ratio("density", units.mass / volume);
  }
  const double cutoff = second.cutoff / units.time;
  if (std::abs(cutoff - first.cutoff) > unequal * first.cutoff) {
    throw InvalidInput("cutoff: got " + std::to_string(first.cutoff) + " for the first body and " +
                       std::to_string(cutoff) +
                       " for the second, allowed one frequency for both (in c/R of the first)");
  }
}

void refuse_unequal(const Body& first, const Body& second, double share, const std::string& what) {
  const double time = UnitRatios(second, first).time;
  const std::string most = shown(std::floor(share * std::max(time, 1.0 / time)));
  throw InvalidInput("against: got '" + second.name + "' for '" + first.name + "', allowed " + what +
                     "a body whose R/c is at most " + most +
                     " times that of the other (a larger one has more modes than are computed; an infinite one, a "
                     "half-space or half-plane, is its limit)");
}

}  // namespace stoss
