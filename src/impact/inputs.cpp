#include "impact/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "check.hpp"
#include "impact/strain.hpp"
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

void show_inputs(const Contact& contact, double speed, const FixedResolution& resolution, const ImpactOptions& options,
                 Impact& impact) {
  impact.contact = name(contact);
  impact.start = options.start;
  impact.wall = contact.wall;
  impact.cutoff = contact.cutoff;
  impact.resolution = resolution;
  impact.strain = greatest_strain(contact, speed, options, impact);
  impact.beyond_small_strain = impact.strain > small_strain_limit;
}

}  // namespace stoss
