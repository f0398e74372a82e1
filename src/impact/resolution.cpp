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
double initial_half_width(const Contact& contact, double speed) {
  constexpr double margin = 1.25;
  const double touching = margin * expected_half_width(contact, speed);
  const auto* soft = std::get_if<ExponentialWall>(&contact.wall);
  const double gap = soft == nullptr ? 0.0 : 30.0 / soft->hardness;
  return std::min(std::sqrt(touching * touching + 2.0 * gap), greatest_half_width(contact));
}

/// Nodes at which the Nyquist order π/h of the grid is the highest kept order.
int nyquist_nodes(const Contact& contact, double half_width) {
  return static_cast<int>(std::ceil(half_width * highest_wave_number(contact) / std::numbers::pi));
}

int nodes_within(const Contact& contact, double half_width) {
  if (has_single_point(contact)) return 1;
  constexpr int fewest = 64;
  double nodes = std::max<double>(fewest, 1.5 * nyquist_nodes(contact, half_width));
  if (const auto* soft = std::get_if<ExponentialWall>(&contact.wall)) {
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

double recommended_step(const Contact& contact, double speed, Tail tail) {
  require_speed(speed);
  if (const auto* soft = std::get_if<ExponentialWall>(&contact.wall)) {
    // The edge layer on the soft wall oscillates at about √(α v ω_c), and what first touches it bounces within 1/(α v).
    const double bounce = soft->hardness * speed;
    return 0.25 / std::sqrt(contact.cutoff * (contact.cutoff + bounce) + 0.5 * bounce * bounce);
  }
  if (tail == Tail::radiating) {
    return std::min(0.25 / (contact.cutoff * (1.0 + own_speed(contact, speed))), contact.stable_step);
  }
  // Without damping, the nodes at the edge of the contact bounce the more the faster it spreads.
  return 0.2 / (contact.cutoff * (1.0 + 16.0 * own_speed(contact, speed)));
}

int recommended_nodes(const Contact& contact, double speed) {
  require_speed(speed);
  return nodes_within(contact, initial_half_width(contact, speed));
}

Resolution choose_resolution(const Contact& contact, double speed, const ImpactOptions& options) {
  require_speed(speed);
  if (options.start) require_start(*options.start, speed);
  require("observe_every", static_cast<long>(options.observe_every), 1, 1'000'000'000,
          "steps between two calls of the observer");
  if (options.step) {
    const double least = 5e-6 * std::min(1.0, time_scale(contact));
    require("step", *options.step,
            {least, 1.0 / contact.cutoff, true, true, "5e-6 (of two bodies, less where they meet faster) to 1/cutoff"},
            "time step in R/c; 0.25/cutoff is usual");
  }
  if (options.half_width) {
    require("half_width", *options.half_width,
            {0.0, std::max(greatest_half_width(contact), 1e-300), false, true,
             "above 0 and up to the end of the edge that can touch"},
            "half-width of the contact grid in R");
  }
  const double half_width = options.half_width ? *options.half_width : initial_half_width(contact, speed);
  if (options.nodes) {
    const long fewest = !has_single_point(contact) ? std::max(16, nyquist_nodes(contact, half_width)) : 1;
    require("nodes", static_cast<long>(*options.nodes), fewest, max_nodes,
            "contact nodes; as many as the kept orders need");
  }
  return {half_width, options.step ? *options.step : recommended_step(contact, speed, options.tail),
          options.nodes ? *options.nodes : nodes_within(contact, half_width)};
}

ImpactOptions refined_resolution(const Contact& contact, double speed, double half_width) {
  ImpactOptions options;
  options.step = std::min(0.5 / contact.cutoff, contact.stable_step);
  if (has_single_point(contact)) return options;
  // A coarser run shows how far the contact spreads.
  constexpr double margin = 1.06;
  const double width = half_width > 0.0 ? std::min(margin * half_width, greatest_half_width(contact))
                                        : initial_half_width(contact, speed);
  // The pressure varies over the contact; and over the waves that the kept modes send along the edge.
  const double cutoff = contact.cutoff * time_scale(contact);
  const double nodes = std::max({20.0 * std::pow(cutoff / 12.5, 0.65), 1.3 * cutoff * std::sqrt(width / contact.radius),
                                 1.02 * nyquist_nodes(contact, width)});
  constexpr double vector = 8.0;
  options.half_width = width;
  options.nodes = static_cast<int>(std::min<double>(vector * std::ceil(nodes / vector), max_nodes));
  return options;
}

Resolution widened(const Contact& contact, const Resolution& resolution) {
  constexpr double growth = 1.4;
  const double half_width = std::min(growth * resolution.half_width, greatest_half_width(contact));
  const double nodes = std::ceil(resolution.nodes * half_width / resolution.half_width);
  return {half_width, resolution.step, static_cast<int>(std::min<double>(nodes, max_nodes))};
}

}  // namespace stoss
