#include "stoss/impact/oblique.hpp"

#include "contact/along.hpp"
#include "impact/inputs.hpp"
#include "impact/oblique/film.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/oblique/sided/coupled_impact.hpp"

namespace stoss {

ObliqueImpact oblique_impact(const Contact& contact, double speed, const Obliquity& obliquity,
                             const ImpactOptions& options, const ObliqueObservation& observation) {
  const ObliqueFrame frame(contact, speed, options);
  frame.require(obliquity);
  require_every(observation.every);
  if (obliquity.friction > 0.0) {
    // Rings that move in one direction do not mix it with the normal one.
    if (contact.first->contour == Contour::ball) {
      return Slides(contact, speed, options).after(obliquity, options.poll, observation);
    }
    return coupled_impact(contact, contacts_along(contact, options.poll), speed, obliquity, options, observation);
  }
  if (observation.observer) return smooth_impact({contact, speed, options}, obliquity, observation);
  return frame.joined(impact(contact, speed, options), obliquity, ObliqueFrame::unchanged(obliquity));
}

}  // namespace stoss
