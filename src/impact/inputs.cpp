#include "impact/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "check.hpp"
#include "contact/unit_ratios.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double small_strain_limit = 0.5;  // compression, R

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

}  // namespace

void require_start(const State& start, double speed) {
  if (start.velocity != speed) {
    throw InvalidInput("start: got velocity " + std::to_string(start.velocity) + ", allowed the speed of the impact, " +
                       std::to_string(speed) + " (it is given twice)");
  }
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!finite(start.center) || !std::all_of(start.coordinate.begin(), start.coordinate.end(), finite) ||
      !std::all_of(start.momentum.begin(), start.momentum.end(), finite)) {
    throw InvalidInput(
        "start: got a center, coordinate or momentum that is no finite number, allowed finite ones (nan?)");
  }
}

std::shared_ptr<const Body> required_body(const Contact& contact, int number) {
  if (auto body = body_of(contact, number)) return body;
  throw InvalidInput("body: got number " + std::to_string(number) + " of '" + name(contact) + "', allowed " +
                     (body_of(contact, 1) == nullptr ? "0 (a wall has no inside)" : "0 or 1"));
}

void require_every(int every) {
  require("every", static_cast<long>(every), 1, 1'000'000'000, "steps between two calls of the observer");
}

void require_resolved(double energy_error) {
  constexpr double most = 1e-2;
  if (std::abs(energy_error) <= most) return;
  throw NotConverged("impact: " + std::to_string(energy_error) +
                     " of the energy is unaccounted for (use a smaller step)");
}

void show_inputs(const Contact& contact, double speed, const FixedResolution& resolution, const ImpactOptions& options,
                 Impact& impact) {
  impact.contact = name(contact);
  impact.start = options.start;
  impact.wall = contact.wall;
  impact.cutoff = contact.cutoff;
  impact.resolution = resolution;
  impact.beyond_small_strain = own_speed(contact, speed) > small_strain_speed ||
                               own_compression(contact, impact.max_compression) > small_strain_limit ||
                               (options.start && own_vibration_speed(contact, *options.start) > small_strain_speed);
}

}  // namespace stoss
