#include "impact/grid_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stoss {
namespace {

double asked(const Sampling& sampling, double cutoff, double half_width) {
  return std::max(sampling.points * std::pow(cutoff / sampling.cutoff, sampling.power),
                  sampling.along_edge * cutoff * std::sqrt(half_width));
}

int fewest_nodes(const Contact& contact) {
  const int first = contact.first->sampling.fewest;
  return contact.second == nullptr ? first : std::max(first, contact.second->sampling.fewest);
}

}  // namespace

double initial_half_width(const Contact& contact, double speed) {
  constexpr double margin = 1.25;
  const double touching = margin * expected_half_width(contact, speed);
  const auto* soft = std::get_if<ExponentialWall>(&contact.wall);
  const double gap = soft == nullptr ? 0.0 : 30.0 / soft->hardness;
  return std::min(std::sqrt(touching * touching + 2.0 * gap), greatest_half_width(contact));
}

int nyquist_nodes(const Contact& contact, double half_width) {
  return static_cast<int>(std::ceil(half_width * highest_wave_number(contact) / std::numbers::pi));
}

double sampled_nodes(const Contact& contact, double half_width) {
  const double cutoff = contact.cutoff * time_scale(contact), width = half_width / contact.radius;
  const double first = asked(contact.first->sampling, cutoff, width);
  return contact.second == nullptr ? first : std::max(first, asked(contact.second->sampling, cutoff, width));
}

int nodes_within(const Contact& contact, double half_width) {
  if (has_single_point(contact)) return 1;
  double nodes = std::max<double>(fewest_nodes(contact), 1.5 * nyquist_nodes(contact, half_width));
  if (const auto* soft = std::get_if<ExponentialWall>(&contact.wall)) {
    nodes = std::max({nodes, 128.0, soft->hardness * half_width * half_width});
  }
  return static_cast<int>(std::ceil(std::min<double>(nodes, most_nodes)));
}

}  // namespace stoss
