#include "impact/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "check.hpp"
#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {

void require_start(const State& start, double speed) {
  if (start.velocity != speed) {
    throw InvalidInput::out_of_range("start", "velocity " + std::to_string(start.velocity),
                                     "the speed of the impact, " + std::to_string(speed), "it is given twice");
  }
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!finite(start.center) || !std::all_of(start.coordinate.begin(), start.coordinate.end(), finite) ||
      !std::all_of(start.momentum.begin(), start.momentum.end(), finite)) {
    throw InvalidInput::out_of_range("start", "a center, coordinate or momentum that is no finite number",
                                     "finite ones", "nan?");
  }
}

std::shared_ptr<const Body> required_body(const Contact& contact, int number) {
  if (auto body = body_of(contact, number)) return body;
  throw InvalidInput::out_of_range("body", "number " + std::to_string(number) + " of '" + name(contact) + "'",
                                   (body_of(contact, 1) == nullptr ? "0 (a wall has no inside)" : "0 or 1"));
}

void require_every(int every) {
  require("every", static_cast<long>(every), 1, 1'000'000'000, "steps between two calls of the observer");
}

void require_resolved(double energy_error) {
  constexpr double most = 1e-2;
  if (std::abs(energy_error) <= most) return;
  throw NotConverged("impact: " + std::to_string(energy_error) + " of the energy is unaccounted for", "step",
                     "use a smaller step");
}

void fill_inputs(const Contact& contact, double speed, const FixedResolution& resolution, const ImpactOptions& options,
                 Impact& impact) {
  impact.contact = name(contact);
  impact.start = options.start;
  impact.wall = contact.wall;
  impact.cutoff = contact.cutoff;
  impact.resolution = resolution;
  impact.strain = greatest_strain(contact, speed, options, impact);
  impact.beyond_small_strain = impact.strain > small_strain_limit;
}

namespace {

/// Maximum of the root mean square velocities with which the bodies vibrate, each in its own wave speed: with all
/// energy of its modes kinetic, √(2E/m).
double own_vibration_speed(const Contact& contact, const State& state) {
  const std::vector<double> energies = mode_energies(contact, state);
  const auto speed = [&](std::size_t begin, std::size_t end, std::size_t first_mode) {
    double twice = 0.0;
    for (std::size_t g = begin, k = first_mode; g < end; ++g) {
      for (std::size_t l = 0; l < contact.groups[g].omega.size(); ++l, ++k) {
        twice += 2.0 * energies[k] / modal_mass(contact, g);
      }
    }
    return std::sqrt(twice);
  };
  std::size_t of_first = 0;
  for (std::size_t g = 0; g < contact.first_groups; ++g) of_first += contact.groups[g].omega.size();
  const double first = speed(0, contact.first_groups, 0);
  if (lasting_groups(contact) == contact.first_groups) return first;
  const UnitRatios units = units_of(contact, 1);
  return std::max(first, speed(contact.first_groups, contact.groups.size(), of_first) * units.time / units.length);
}

double strain_of(const Body& body, const Load& load) {
  if (body.softness == 0.0) return 0.0;
  if (body.contour == Contour::flat) return load.force;  // of a section 1 and a modulus 1
  if (load.half_width <= 0.0) return 0.0;
  const double own = body.strain ? body.strain(load) : 0.0;
  return std::max(own, strain_of_contact * body.softness * pressure(body.contour, load));
}

/// Force between flat ends: that of the first waves, and where these are all that is known, as the force of a lossy
/// material is mostly viscous at first, no other.
double force_of_waves(const Contact& contact, double speed, double greatest) {
  constexpr double ripple = 0.005;  // that it may have left (FlatForce)
  const double second = contact.second == nullptr ? 0.0 : 1.0 / units_of(contact, 1).impedance;
  const double first = speed / (1.0 + second);
  return loses(contact) ? first : std::max(first, (1.0 - ripple) * greatest);
}

/// That of whatever is strained most:
///
///   v/c            what a body of a wave speed c takes part in the approach with: the strain of a rod, and of any
///                  first wave
///   √(2E/m)/c      the same of the vibration before, of energy E
///   0.47 p/E*      the contact: p = F/πa² (F/2a of a line) is 0.42 E* a/R in Hertz's contact, and 0.2 a/R the mean
///                  strain there (Tabor, The Hardness of Metals, 1951)
///   Body::strain   of what has layers or is thin
double greatest_strain(const Contact& contact, double speed, Load load) {
  const bool flat = has_single_point(contact);
  if (flat) load.force = force_of_waves(contact, speed, load.force);
  double greatest = flat ? 0.0 : mach_number(contact, speed);
  for (int number = 0; number < 2; ++number) {
    const std::shared_ptr<const Body> body = body_of(contact, number);
    if (body == nullptr) break;
    const UnitRatios units = units_of(contact, number);
    greatest = std::max(greatest, strain_of(*body, {load.force / units.force, load.half_width / units.length,
                                                    load.compression / units.length, load.duration / units.time}));
  }
  return greatest;
}

}  // namespace

double greatest_strain(const Contact& contact, double speed, const ImpactOptions& options, const Impact& impact) {
  const double vibration = options.start ? own_vibration_speed(contact, *options.start) : 0.0;
  const Load load{impact.max_force * whole_mass(*contact.first), impact.max_half_width, impact.max_compression,
                  impact.contact_time};
  return std::max(vibration, greatest_strain(contact, speed, load));
}

double expected_strain(const Contact& contact, double speed) {
  if (has_single_point(contact)) return greatest_strain(contact, speed, Load{});
  const Touch met = touch(contact);
  Load load{.half_width = expected_half_width(contact, speed), .duration = expected_duration(contact, speed)};
  load.compression = load.half_width * load.half_width * met.curvature;
  // F = 4a³/3R · E* on a circle, πa²/4R · E* on a line.
  constexpr double on_a_circle = 4.0 / 3.0, on_a_line = 0.25 * std::numbers::pi;
  load.force = load.compression / met.softness * (met.circle ? on_a_circle * load.half_width : on_a_line);
  return greatest_strain(contact, speed, load);
}

std::string named(const Oscillation& mode) {
  return "mode (" + std::to_string(mode.order) + ", " + std::to_string(mode.index) + ") of the " +
         (mode.body == 0 ? "first" : "second") + " body";
}

void require_possible(const Contact& contact, const Oscillation& mode) {
  const auto its = body_of(contact, mode.body);
  if (its == nullptr) {
    throw InvalidInput::out_of_range("vibration", "a mode of body " + std::to_string(mode.body),
                                     body_of(contact, 1) == nullptr ? "0" : "0 or 1", "a wall has no modes");
  }
  const Body& body = *its;
  if (!is_whole(body)) {
    throw InvalidInput::out_of_range("vibration", "a mode of '" + short_name(body) + "'",
                                     "modes of bodies that are there as a whole", "the waves of this one run away");
  }
  if (is_known_at_a_point(body)) {
    throw InvalidInput::out_of_range("vibration", "a mode of '" + body.name + "'",
                                     "modes of bodies that are known as a whole", "of this one a point is");
  }
  if (mode.order < 0 || mode.index < 0) {
    throw InvalidInput::out_of_range("vibration", named(mode), "an order and an index of 0 or more");
  }
  const auto has_order = [&mode](const ModeGroup& group) { return group.order == mode.order; };
  if (mode.order != 0 && has_single_point(contact) && std::none_of(body.groups.begin(), body.groups.end(), has_order)) {
    throw InvalidInput::out_of_range("vibration", named(mode), "order 0", "a flat end has no other");
  }
}

}  // namespace stoss
