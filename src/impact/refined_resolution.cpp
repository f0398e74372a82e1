#include "impact/refined_resolution.hpp"

#include <algorithm>
#include <cmath>

#include "impact/grid_size.hpp"

namespace stoss {

Resolution refined_resolution(const Contact& contact, double speed, double half_width) {
  Resolution resolution;
  resolution.step = std::min(0.5 / contact.cutoff, contact.stable_step);
  if (has_single_point(contact)) return resolution;
  // A coarser run shows how far the contact spreads.
  constexpr double margin = 1.06;
  const double width = half_width > 0.0 ? std::min(margin * half_width, greatest_half_width(contact))
                                        : initial_half_width(contact, speed);
  const double nodes = std::max(sampled_nodes(contact, width), 1.02 * nyquist_nodes(contact, width));
  constexpr double vector = 8.0;
  resolution.half_width = width;
  resolution.nodes = static_cast<int>(std::min<double>(vector * std::ceil(nodes / vector), most_nodes));
  return resolution;
}

}  // namespace stoss
