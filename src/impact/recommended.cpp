#include "impact/recommended.hpp"
#include "stoss/contact/grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/demands.hpp"
#include "contact/touch.hpp"
#include "contact/yield/yielding_contact.hpp"

namespace stoss {
namespace {

double asked(const Sampling& sampling, double cutoff, double half_width) {
  return std::max(sampling.points * std::pow(cutoff / sampling.cutoff, sampling.power),
                  sampling.along_edge * cutoff * std::sqrt(half_width));
}

/// The nearest of half-widths of a fixed ratio, so that neighbouring impacts have the same grid (ContactCache).
double in_steps(const Contact& contact, double half_width) {
  constexpr double steps = 64.0;
  return contact.radius * std::exp2(std::round(steps * std::log2(half_width / contact.radius)) / steps);
}

/// Of the points over the contact that is expected.
double margin_of(const Contact& contact) { return contact.yield.yield > 0.0 ? points_over_yielding_contact : 1.25; }

/// @param pushing gap up to which points push that have not touched
double first_half_width(const Contact& contact, double speed, double pushing) {
  const double touching = margin_of(contact) * expected_half_width(contact, speed);
  const double beyond = pushing > 0.0 ? 2.0 * pushing / touch(contact).curvature : 0.0;
  return std::min(std::sqrt(touching * touching + beyond), greatest_half_width(contact));
}

/// Step in which asperities are pressed by a share of their length. Where they are long, forces change slowly, and are
/// too soft to drive the modes within a step.
double step_of_asperities(const Contact& contact, double speed) {
  constexpr double share = 0.2;
  return std::min(share * contact.asperities / speed, 1.0 / contact.cutoff);
}

int fewest_nodes(const Contact& contact) {
  const int first = contact.first->sampling.fewest;
  return contact.second == nullptr ? first : std::max(first, contact.second->sampling.fewest);
}

}  // namespace

double initial_half_width(const Contact& contact, double speed) {
  return first_half_width(contact, speed, pushing_gap(contact));
}

int nyquist_nodes(const Contact& contact, double half_width) {
  return static_cast<int>(std::ceil(half_width * highest_wave_number(contact) / std::numbers::pi));
}

double sampled_nodes(const Contact& contact, double half_width) {
  const double cutoff = contact.cutoff * time_scale(contact), width = half_width / contact.radius;
  const double first = asked(contact.first->sampling, cutoff, width);
  return contact.second == nullptr ? first : std::max(first, asked(contact.second->sampling, cutoff, width));
}

int nodes_within(const Contact& contact, Tail tail, double half_width) {
  if (has_single_point(contact)) return 1;
  const double nodes = std::max(
      {1.0 * fewest_nodes(contact), 1.5 * nyquist_nodes(contact, half_width), needed_nodes(contact, tail, half_width)});
  return static_cast<int>(std::ceil(std::min<double>(nodes, most_nodes)));
}

double known_half_width(const Contact& contact, double speed, const Impact& coarser) {
  constexpr double spacings = 2.0, share = 0.25;
  const FixedResolution& grid = coarser.resolution;
  if (grid.nodes < 2) return 0.0;
  if (contact.yield.yield > 0.0) return 0.0;  // known beforehand
  if (contact.asperities > 0.0) return 0.0;   // they push beyond what counts as contact
  const bool resolved = coarser.max_half_width > spacings * grid.half_width / grid.nodes;
  return resolved ? coarser.max_half_width : share * initial_half_width(contact, speed);
}

Resolution refined_resolution(const Contact& contact, double speed, double half_width) {
  Resolution resolution;
  resolution.step = std::max(std::min(0.5 / contact.cutoff, contact.stable_step), step_of_asperities(contact, speed));
  if (has_single_point(contact)) return resolution;
  constexpr double fewest_steps = 1000.0;  // of a contact that turns at its deepest with a bend
  if (contact.yield.yield > 0.0)
    resolution.step = std::min(*resolution.step, expected_duration(contact, speed) / fewest_steps);
  // A coarser run shows how far the contact spreads. The edge law needs room beyond it: most of two spacings.
  constexpr double margin = 1.06, spacings = 2.0;
  constexpr double matters = 16.0;  // lengths of the asperities from the face where pressure is down to 10⁻⁷
  constexpr int fewest = 16;
  const double expected =
      half_width > 0.0 ? half_width : first_half_width(contact, speed, matters * contact.asperities);
  const double width = in_steps(contact, expected);
  const bool local = contact.yield.yield > 0.0;  // the points only carry shapes of modes
  const double wanted = local ? fewest : std::max<double>(sampled_nodes(contact, width), fewest);
  resolution.half_width = std::min(width * std::max(margin, 1.0 + spacings / wanted), greatest_half_width(contact));
  const double nodes = std::max(wanted, 1.02 * nyquist_nodes(contact, *resolution.half_width));
  constexpr double vector = 8.0;
  const double rounding = contact.second == nullptr ? 0.0 : 1e-12;  // of its units: 48.000…1 means 48
  const double vectors = std::ceil((1.0 - rounding) * nodes / vector);
  resolution.nodes = static_cast<int>(std::min<double>(vector * vectors, most_nodes));
  return resolution;
}

FixedResolution widened(const Contact& contact, const FixedResolution& resolution) {
  constexpr double growth = 1.4;
  const double half_width = std::min(growth * resolution.half_width, greatest_half_width(contact));
  const double nodes = std::ceil(resolution.nodes * half_width / resolution.half_width);
  FixedResolution wider = resolution;
  wider.half_width = half_width;
  wider.nodes = static_cast<int>(std::min<double>(nodes, most_nodes));
  return wider;
}

}  // namespace stoss
