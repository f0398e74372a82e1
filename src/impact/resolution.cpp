#include "impact/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr int max_nodes = 4096;

/// The grid must cover the contact with room to spare, and with a soft wall the gap in which it still pushes.
double initial_half_width(const Body& body, const Wall& wall, double speed) {
  constexpr double margin = 1.25;
  const double contact = margin * body.expected_half_width(speed);
  const auto* soft = std::get_if<ExponentialWall>(&wall);
  const double gap = soft == nullptr ? 0.0 : 30.0 / soft->hardness;
  return std::min(std::sqrt(contact * contact + 2.0 * gap), reachable_half_width(body, wall));
}

/// Nodes at which the Nyquist order π/h of the grid is the highest kept order.
int nyquist_nodes(const Body& body, double half_width) {
  int highest = 0;
  for (const ModeGroup& group : body.groups) highest = std::max(highest, group.order);
  return static_cast<int>(std::ceil(half_width * highest / std::numbers::pi));
}

int nodes_within(const Body& body, const Wall& wall, double half_width) {
  if (body.max_half_width == 0.0) return 1;
  constexpr int fewest = 64;
  double nodes = std::max<double>(fewest, 1.5 * nyquist_nodes(body, half_width));
  if (const auto* soft = std::get_if<ExponentialWall>(&wall)) {
    nodes = std::max({nodes, 128.0, soft->hardness * half_width * half_width});
  }
  return static_cast<int>(std::ceil(std::min<double>(nodes, max_nodes)));
}

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

double reachable_half_width(const Body& body, const Wall& wall) {
  return std::holds_alternative<ExponentialWall>(wall) ? 0.5 * body.max_half_width : body.max_half_width;
}

double recommended_step(const Body& body, const Wall& wall, double speed) {
  validate(wall);
  require_speed(speed);
  if (const auto* soft = std::get_if<ExponentialWall>(&wall)) {
    // The edge layer on the soft wall oscillates at about √(α v ω_c), and what first touches it bounces within 1/(α v).
    const double bounce = soft->hardness * speed;
    return 0.25 / std::sqrt(body.cutoff * (body.cutoff + bounce) + 0.5 * bounce * bounce);
  }
  if (std::get<HardWall>(wall).tail == Tail::radiating) {
    return std::min(0.25 / (body.cutoff * (1.0 + speed)), body.stable_step);
  }
  // Without damping, the nodes at the edge of the contact bounce the more the faster it spreads.
  return 0.2 / (body.cutoff * (1.0 + 16.0 * speed));
}

int recommended_nodes(const Body& body, const Wall& wall, double speed) {
  validate(wall);
  require_speed(speed);
  return nodes_within(body, wall, initial_half_width(body, wall, speed));
}

Resolution choose_resolution(const Body& body, const Wall& wall, double speed, const ImpactOptions& options) {
  require_speed(speed);
  validate(body);
  validate(wall);
  if (options.start) require_start(*options.start, speed);
  require("observe_every", static_cast<long>(options.observe_every), 1, 1'000'000'000,
          "steps between two calls of the observer");
  if (options.step) {
    require("step", *options.step, {5e-6, 1.0 / body.cutoff, true, true, "5e-6 to 1/cutoff"},
            "time step in R/c; 0.25/cutoff is usual");
  }
  if (options.half_width) {
    require("half_width", *options.half_width,
            {0.0, std::max(reachable_half_width(body, wall), 1e-300), false, true,
             "above 0 and up to the end of the edge that the wall acts on"},
            "half-width of the contact grid in R");
  }
  const double half_width = options.half_width ? *options.half_width : initial_half_width(body, wall, speed);
  if (options.nodes) {
    const long fewest = body.max_half_width > 0.0 ? std::max(16, nyquist_nodes(body, half_width)) : 1;
    require("nodes", static_cast<long>(*options.nodes), fewest, max_nodes,
            "contact nodes; as many as the kept orders need");
  }
  return {half_width, options.step ? *options.step : recommended_step(body, wall, speed),
          options.nodes ? *options.nodes : nodes_within(body, wall, half_width)};
}

ImpactOptions refined_resolution(const Body& body, double speed, double half_width) {
  ImpactOptions options;
  options.step = std::min(0.5 / body.cutoff, body.stable_step);
  if (body.max_half_width == 0.0) return options;
  // A coarser run shows how far the contact spreads.
  constexpr double margin = 1.06;
  const double width = half_width > 0.0 ? std::min(margin * half_width, body.max_half_width)
                                        : initial_half_width(body, HardWall{}, speed);
  // The pressure varies over the contact; and over the waves that the kept modes send along the edge.
  const double nodes = std::max({20.0 * std::pow(body.cutoff / 12.5, 0.65), 1.3 * body.cutoff * std::sqrt(width),
                                 1.02 * nyquist_nodes(body, width)});
  constexpr double vector = 8.0;
  options.half_width = width;
  options.nodes = static_cast<int>(std::min<double>(vector * std::ceil(nodes / vector), max_nodes));
  return options;
}

Resolution widened(const Body& body, const Wall& wall, const Resolution& resolution) {
  constexpr double growth = 1.4;
  const double half_width = std::min(growth * resolution.half_width, reachable_half_width(body, wall));
  const double nodes = std::ceil(resolution.nodes * half_width / resolution.half_width);
  return {half_width, resolution.step, static_cast<int>(std::min<double>(nodes, max_nodes))};
}

}  // namespace stoss
