#include "contact/unit_ratios.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double unequal = 1e-9;

/// Refuses what is beyond `most`, by a value of six digits: it is computed of what was given.
void require_below(const std::string& name, double ratio, double most, std::string_view shown_most,
                   const std::string& hint) {
  constexpr double least = 1e-3 * (1.0 - unequal);
  if (ratio >= least && ratio <= most * (1.0 + unequal)) return;
  throw InvalidInput::out_of_range(name + " ratio", rounded(ratio), "0.001 to " + std::string(shown_most), hint);
}

void require_ratio(const std::string& name, double ratio, std::string_view hint = {}) {
  require_below(name, ratio, 1e3, "1000", "of the second body to the first" + std::string(hint));
}

/// @param of what has no end
void require_ratio_of_half_space(const std::string& name, const Body& of, double ratio, std::string_view hint = {}) {
  require_below(name, ratio, 1e6, "1e6", "of the " + short_name(of) + " to the body" + std::string(hint));
}

/// What to do about waves of the stiffer one that are too fast for the steps of the other, and by which input.
struct WayOut {
  std::string_view hint, input;
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
  const std::string way =
      "; the waves of the stiffer one are too fast for the steps of the other: " + std::string(hint);
  try {
    if (is_unbounded(second)) {
      require_ratio_of_half_space("young", second, ratio, way);
    } else {
      require_ratio("young", ratio, way);
    }
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

/// Refuses a contact that is far from a circle. @param other curvature of what the body meets, in its units
void require_round(const Body& body, double other) {
  constexpr double most = 4.0;
  const double mean = body.curvature + other, half = 0.5 * body.curvature_difference;
  if (mean > half && mean + half <= most * (mean - half)) return;
  throw InvalidInput::out_of_range(
      "curvature", "principal curvatures of '" + body.name + "' that make a long contact with what it meets",
      "relative ones up to 4 : 1");
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
    require_ratio_of_half_space("density", second, units.mass / (units.length * units.length * size));
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
