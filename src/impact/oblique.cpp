#include "stoss/impact/oblique.hpp"

#include "impact/oblique_frame.hpp"

namespace stoss {

ObliqueImpact oblique_impact(const Contact& contact, double speed, const Obliquity& obliquity,
                             const ImpactOptions& options) {
  const ObliqueFrame frame(contact, speed, options);
  frame.require(obliquity);
  if (obliquity.friction > 0.0) return Slides(contact, speed, options).after(obliquity, options.poll);
  return frame.joined(impact(contact, speed, options), obliquity, ObliqueFrame::unchanged(obliquity));
}

}  // namespace stoss
