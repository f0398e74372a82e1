#include "impact/refined_resolution.hpp"

#include <algorithm>
#include <cmath>

#include "impact/grid_size.hpp"

namespace stoss {

Resolution refined_resolution(const Contact& contact, double speed, double half_width) {
  Resolution resolution;
  resolution.step = std::min(0.5 / contact.cutoff, contact.stable_step);
  if (has_single_point(contact)) return resolution;
  // A coarser run shows how far the contact spreads. The edge law needs room beyond it: most of two spacings.
  constexpr double margin = 1.06, spacings = 2.0;
  const double width = half_width > 0.0 ? half_width : initial_half_width(contact, speed);
  // The pressure varies over the contact; and over the waves that the kept modes send along the edge.
  const double cutoff = contact.cutoff * time_scale(contact);
  const double wanted =
      std::max({24.0 * std::pow(cutoff / 32.0, 0.65), 0.7 * cutoff * std::sqrt(width / contact.radius), 16.0});
  resolution.half_width = std::min(width * std::max(margin, 1.0 + spacings / wanted), greatest_half_width(contact));
  const double nodes = std::max(wanted, 1.02 * nyquist_nodes(contact, *resolution.half_width));
  constexpr double vector = 8.0;
  resolution.nodes = static_cast<int>(std::min<double>(vector * std::ceil(nodes / vector), most_nodes));
  return resolution;
}

}  // namespace stoss
