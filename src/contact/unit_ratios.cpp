#include "contact/unit_ratios.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "check.hpp"
#include "contact/ellipse.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double unequal = 1e-9;

/// What a ratio of the second body to the first may be.
struct Ratios {
  double least, most;
  std::string_view shown;
};

constexpr Ratios of_bodies{1e-3, 1e3, "0.001 to 1000"}, of_densities{1e-3, 1e6, "0.001 to 1e6"},
    of_moduli{1e-6, 1e6, "1e-6 to 1e6"};

/// Refuses a ratio beyond them, by a value of six digits: it is computed of what was given.
void require_ratio(const std::string& name, double ratio, const Ratios& allowed, const std::string& hint) {
  if (ratio >= allowed.least * (1.0 - unequal) && ratio <= allowed.most * (1.0 + unequal)) return;
  throw InvalidInput::out_of_range(name + " ratio", rounded(ratio), std::string(allowed.shown), hint);
}

void require_ratio(const std::string& name, double ratio, std::string_view hint = {}) {
  require_ratio(name, ratio, of_bodies, "of the second body to the first" + std::string(hint));
}

/// What to do about a stiffer one whose own deformation is lost beside that of the other, and by which input.
struct WayOut {
  std::string hint;
  std::string_view input;
};

WayOut way_out(const Body& first, const Body& second, bool second_is_stiffer) {
  if (second_is_stiffer && is_unbounded(second)) return {"let it be a wall", "against"};
  if (second_is_stiffer) return {"let the second be rigid", "against rigid"};
  if (is_known_at_a_point(first)) return {"take a rigid sphere of its radius in its place", ""};
  return {"let the first be rigid", "rigid"};
}

/// The modulus of a rigid body is only a unit: whatever it is, ratios to it say nothing.
void require_young(const Body& first, const Body& second, double softness) {
  if (first.softness == 0.0 || second.softness == 0.0) return;
  const double ratio = 1.0 / softness;
  const auto [hint, input] = way_out(first, second, ratio > 1.0);
  const std::string of = is_unbounded(second) ? short_name(second) + " to the body" : "second body to the first";
  try {
    require_ratio("young", ratio, of_moduli, "of the " + of + "; beyond, the stiffer one is rigid: " + hint);
  } catch (const InvalidInput& refusal) {
    throw refusal.with_way(input);
  }
}

void require_contours(const Body& first, const Body& second) {
  if (first.contour == second.contour) return;
  throw InvalidInput::out_of_range("against", "'" + short_name(second) + "' for '" + short_name(first) + "'",
                                   "a body of the same kind of end",
                                   "a disk meets disks and half-planes, a sphere spheres and half-spaces, a rod rods");
}

}  // namespace

std::string short_name(const Body& body) {
  if (is_known_at_a_point(body)) return body.name;  // as it was given
  const std::size_t equals = body.name.find('=');
  return equals == std::string::npos ? body.name : body.name.substr(0, body.name.rfind(' ', equals));
}

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

void require_ratios(const Body& first, const Body& second) {
  require_contours(first, second);
  if (is_unbounded(first) || first.held) {
    throw InvalidInput::conflict("body",
                                 "'" + short_name(first) + "' cannot be the first body, because it does not move",
                                 "let the other body meet it");
  }
  if (first.softness == 0.0 && second.softness == 0.0) {
    throw InvalidInput::conflict("rigid", "both bodies are rigid, and one of them must deform");
  }
  if (first.contour == Contour::ball && first.curvature + second.curvature == 0.0) {
    throw InvalidInput::conflict("curvature", "the surfaces of '" + short_name(first) + "' and '" + short_name(second) +
                                                  "' are both flat, and at least one must be curved");
  }
  const UnitRatios units(second, first);
  if (first.curvature_difference > 0.0) require_round(first, second.curvature / units.length);
  if (second.curvature_difference > 0.0) require_round(second, first.curvature * units.length);
  if (is_unbounded(second) && is_known_at_a_point(first)) {
    require_young(first, second, units.softness);
  } else if (is_unbounded(second)) {
    const double size = first.contour == Contour::ball ? units.length : 1.0;
    require_young(first, second, units.softness);
    require_ratio("density", units.mass / (units.length * units.length * size), of_densities,
                  "of the " + short_name(second) + " to the body");
  } else if (first.contour == Contour::flat) {
    require_ratio("length", units.length);
    require_ratio("transit time", units.time, "; length sqrt(density/young)");
    require_ratio("impedance", units.impedance, "; area sqrt(young density)");
  } else if (!is_known_at_a_point(first) && !is_known_at_a_point(second)) {
    require_ratio("radius", units.length);
    const double volume = units.length * units.length * (first.contour == Contour::ball ? units.length : 1.0);
    require_young(first, second, units.softness);
    require_ratio("density", units.mass / volume);
  }
}

void require_partners(const Body& first, const Body& second) {
  require_ratios(first, second);
  const UnitRatios units(second, first);
  const double cutoff = second.cutoff / units.time;
  if (std::abs(cutoff - first.cutoff) > unequal * first.cutoff) {
    throw InvalidInput::out_of_range(
        "cutoff", rounded(first.cutoff) + " for the first body and " + rounded(cutoff) + " for the second",
        "one frequency for both", "in c/R of the first");
  }
}

void refuse_unequal(const Body& first, const Body& second, double share, const std::string& what) {
  const double time = UnitRatios(second, first).time;
  const std::string most = shown(std::floor(share * std::max(time, 1.0 / time)));
  throw InvalidInput::out_of_range(
      "against", "'" + short_name(second) + "' of " + rounded(time) + " times the R/c of '" + short_name(first) + "'",
      what + "a body whose R/c is at most " + most + " times that of the other",
      "a larger one has more modes than are computed; an infinite one, a half-space or half-plane, is its limit");
}

}  // namespace stoss
