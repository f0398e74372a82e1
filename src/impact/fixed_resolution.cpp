#include "impact/fixed_resolution.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "check.hpp"
#include "digits.hpp"
#include "impact/grid_size.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

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

}  // namespace

FixedResolution fix(const Contact& contact, double speed, const ImpactOptions& options) {
  require_speed(speed);
  if (contact.radiating && own_speed(contact, speed) > 1.0) {
    throw InvalidInput("speed: got " + shown(speed) + " c at a soft half-space, allowed up to " +
                       shown(speed / own_speed(contact, speed)) + " (the wave speed of the softer body)");
  }
  if (options.start) require_start(*options.start, speed);
  const auto& [step, nodes, asked_half_width, tail] = options.resolution;
  if (step) {
    const double least = 5e-6 * std::min(1.0, time_scale(contact));
    require("step", *step,
            {least, 1.0 / contact.cutoff, true, true, "5e-6 (of two bodies, less where they meet faster) to 1/cutoff"},
            "time step in R/c; 0.25/cutoff is usual");
  }
  if (asked_half_width) {
    require("half_width", *asked_half_width,
            {0.0, std::max(greatest_half_width(contact), 1e-300), false, true,
             "above 0 and up to the end of the edge that can touch"},
            "half-width of the contact grid in R");
  }
  const double half_width = asked_half_width ? *asked_half_width : initial_half_width(contact, speed);
  if (nodes) {
    const long fewest = !has_single_point(contact) ? std::max(16, nyquist_nodes(contact, half_width)) : 1;
    require("nodes", static_cast<long>(*nodes), fewest, most_nodes, "contact nodes; as many as the kept orders need");
  }
  return {half_width, step ? *step : recommended_step(contact, speed, tail),
          nodes ? *nodes : nodes_within(contact, half_width)};
}

FixedResolution widened(const Contact& contact, const FixedResolution& resolution) {
  constexpr double growth = 1.4;
  const double half_width = std::min(growth * resolution.half_width, greatest_half_width(contact));
  const double nodes = std::ceil(resolution.nodes * half_width / resolution.half_width);
  return {half_width, resolution.step, static_cast<int>(std::min<double>(nodes, most_nodes))};
}

}  // namespace stoss
