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
  constexpr int fewest = 16;
  const double width = half_width > 0.0 ? half_width : initial_half_width(contact, speed);
  const double wanted = std::max<double>(sampled_nodes(contact, width), fewest);
  resolution.half_width = std::min(width * std::max(margin, 1.0 + spacings / wanted), greatest_half_width(contact));
  const double nodes = std::max(wanted, 1.02 * nyquist_nodes(contact, *resolution.half_width));
  constexpr double vector = 8.0;
  resolution.nodes = static_cast<int>(std::min<double>(vector * std::ceil(nodes / vector), most_nodes));
  return resolution;
}

}  // namespace stoss
