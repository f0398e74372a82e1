#include "stoss/contact/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "check.hpp"
#include "contact/faces/coats.hpp"
#include "contact/residual/residual_part.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "contact/yield/indentation.hpp"
#include "contact/zener.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Largest angle of a point on the circle. The exponential wall acts on the front half of a body (paper eq. (40)), and
/// behind its widest place a disk touches only a body of its own size (or the wall, where the model means little).
double greatest_angle(const Contact& contact) {
  constexpr double before_the_widest = 0.95;  // where points at equal angles crowd together on a plane
  const bool at_a_point =
      is_known_at_a_point(*contact.first) || (contact.second != nullptr && is_known_at_a_point(*contact.second));
  if (contact.unbounded || at_a_point) return before_the_widest * 0.5 * std::numbers::pi;
  const bool same_size = contact.second == nullptr || contact.second->scale.length == contact.first->scale.length;
  const bool all_around = same_size && contact.asperities == 0.0;
  return all_around ? std::numbers::pi : 0.5 * std::numbers::pi;
}

/// Number of spacings in a half circle for about `nodes` points within half_width.
int spacings(const Contact& contact, double half_width, int nodes) {
  const double greatest = greatest_half_width(contact);
  require("half_width", half_width, {0.0, greatest, false, true, "above 0 and up to pi, or pi/2 of the smaller body"},
          "half-width of the contact grid in R");
  const double wanted = std::numbers::pi * nodes / (half_width / contact.radius);
  require("nodes", static_cast<long>(std::min(wanted, 1e9)), 4, 5'000'000,
          "nodes in a half circle: nodes * pi / half_width");
  return static_cast<int>(wanted * (1.0 + 4.0 * std::numeric_limits<double>::epsilon()));  // 2.999… means 3
}

void require_surface(const Body& body, const Surface& surface, std::size_t points) {
  if (surface.recess.size() == points && surface.measure.size() == points && surface.impedance.size() == points &&
      surface.shape.size() % points == 0 && surface.shape.size() / points >= shape_rows(body)) {
    return;
  }
  throw InvalidInput::out_of_range("body", "a surface of '" + body.name + "' whose arrays do not fit",
                                   "one value per point, and per point and shape");
}

Surface surface_of(const Body& body, const ContactPoints& points) {
  Surface surface = body.surface(points);
  require_surface(body, surface, body.components * points.count);
  return surface;
}

/// Joins the second body's surface to that of the first, in its units: recesses add, impedances are in series.
/// @param points of the contact; values of a second component are those of a body that is turned around
void join(const Surface& second, const UnitRatios& units, std::size_t first_rows, std::size_t points,
          Surface& surface) {
  const std::size_t values = surface.recess.size();
  surface.shape.resize(first_rows * values);
  surface.shape.insert(surface.shape.end(), second.shape.begin(), second.shape.end());
  for (std::size_t k = first_rows * values; k < surface.shape.size(); ++k) {
    if (k % values >= points) surface.shape[k] = -surface.shape[k];
  }
  for (std::size_t i = 0; i < values; ++i) {
    surface.recess[i] += second.recess[i] * units.length;
    surface.impedance[i] = 1.0 / (1.0 / surface.impedance[i] + 1.0 / (second.impedance[i] * units.impedance));
  }
}

/// The sum of one residual matrix of both bodies.
std::vector<double> residual_sum(const Contact& contact, const ContactGrid& grid, Residual residual,
                                 double UnitRatios::*unit, const Poll& poll) {
  std::vector<double> sum = residual_of(contact, grid, 0, residual, poll);
  if (contact.second == nullptr) return sum;
  const double scale = units_of(contact, 1).*unit;
  const std::vector<double> second = residual_of(contact, grid, 1, residual, poll);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += scale * second[i];
  return sum;
}

/// Of Hertz' contact of bare faces.
double bare_half_width(const Contact& contact, double speed) {
  const Touch met = touch(contact);
  if (contact.yield.yield > 0.0) {
    const Onset onset = onset_of(contact, speed);
    return onset.radius * loading_radius(onset.deepest);
  }
  if (met.circle) {
    // Hertz: the energy of the approach is (8/15) δ^{5/2}/(D √curvature), a² = δ/curvature.
    const double energy = 0.5 * contact.whole_mass * speed * speed;
    const double approach = std::pow(1.875 * energy * met.softness * std::sqrt(met.curvature), 0.4);
    return std::sqrt(approach / met.curvature);
  }
  // Hertz in the plane, a² = 4F/π · (1/E₁ + 1/E₂)/(1/R₁ + 1/R₂), with a fit of the maximum force to the impacts of
  // tests/data/contact_hard_wall.csv.
  const double logarithm = std::log1p(1.0 / mach_number(contact, speed));
  const double force =
      speed * std::sqrt(contact.whole_mass / whole_mass(*contact.first) / met.softness) / std::sqrt(1.0 + logarithm);
  return 2.0 * std::sqrt(force * met.softness / met.curvature);
}

double bare_duration(const Contact& contact, double speed) {
  const Touch met = touch(contact);
  if (contact.yield.yield > 0.0) {  // that of an elastic contact as deep, which is longer
    const Onset onset = onset_of(contact, speed);
    return hertzian_duration * onset.depth * onset.deepest / speed;
  }
  const double width = bare_half_width(contact, speed);
  if (met.circle && contact.keeps_displacement) {
    const auto [inelasticity, unit] = zener_scales(contact, speed);
    return zener_impact(inelasticity).duration * unit;
  }
  if (met.circle) return hertzian_duration * width * width * met.curvature / speed;
  // The impulse 2μv over the maximum force, times the shape of the pulse.
  const double force = 0.25 * width * width * met.curvature / met.softness;
  return 3.3 * speed * contact.whole_mass / whole_mass(*contact.first) / force;
}

}  // namespace

double greatest_half_width(const Contact& contact) {
  return has_single_point(contact) ? 0.0 : greatest_angle(contact) * contact.radius;
}

double expected_half_width(const Contact& contact, double speed) {
  if (has_single_point(contact)) return 0.0;
  const double of_coats = 2.0 * coat_compression(contact, speed) / touch(contact).curvature;
  return of_coats == 0.0 ? bare_half_width(contact, speed)
                         : std::sqrt(std::pow(bare_half_width(contact, speed), 2) + of_coats);
}

double expected_duration(const Contact& contact, double speed) {
  constexpr double of_coat = 2.8043642106509084;  // 2 ∫₀¹ dx/√(1 − x³)
  constexpr double of_asperities = 14.0;          // lengths, in which a force rises and falls by a thousand
  const double softer = of_coat * coat_compression(contact, speed) + of_asperities * contact.asperities;
  return bare_duration(contact, speed) + softer / speed;
}

ContactGrid contact_grid(const Contact& contact, double half_width, int nodes) {
  if (has_single_point(contact)) return contact_grid(contact, ContactPoints{});
  return contact_grid(contact, {contact.radius, std::numbers::pi / spacings(contact, half_width, nodes),
                                static_cast<std::size_t>(nodes)});
}

ContactGrid contact_grid(const Contact& contact, const ContactPoints& points) {
  ContactGrid grid;
  grid.points = points;
  static_cast<Surface&>(grid) = surface_of(*contact.first, grid.points);
  if (contact.second != nullptr) {
    const UnitRatios units = units_of(contact, 1);
    join(surface_of(*contact.second, seen_by(grid.points, units)), units, shape_rows(*contact.first), points.count,
         grid);
  }
  for (std::size_t i = 0; i < grid.points.count; ++i) {
    grid.coordinate.push_back(grid.points.angle(i) * grid.points.radius);
  }
  return grid;
}

std::vector<double> residual_compliance(const Contact& contact, const ContactGrid& grid, const Poll& poll) {
  return residual_sum(contact, grid, &Body::residual_compliance, &UnitRatios::compliance, poll);
}

std::vector<double> residual_second_moment(const Contact& contact, const ContactGrid& grid, const Poll& poll) {
  return residual_sum(contact, grid, &Body::residual_second_moment, &UnitRatios::second_moment, poll);
}

}  // namespace stoss
