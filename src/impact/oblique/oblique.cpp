#include "stoss/impact/oblique.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "contact/along.hpp"
#include "impact/ending.hpp"
#include "impact/inputs.hpp"
#include "impact/oblique/coupled_collision.hpp"
#include "impact/oblique/film.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/run.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// One run; empty if the contact outgrew the grid.
std::optional<ObliqueImpact> run_once(const Contact& contact, const std::vector<Contact>& along,
                                      const ObliqueFrame& frame, const Obliquity& obliquity,
                                      const FixedResolution& resolution, const ImpactOptions& options,
                                      const ObliqueObservation& observation) {
  const ContactGrid grid = contact_grid(contact, resolution.half_width, resolution.nodes);
  CoupledCollision collision(contact, along, resolution, grid, frame, obliquity, options.start, options.poll);
  if (observation.observer) collision.show(observation.observer);
  const auto rest = run(contact, frame.speed, resolution, options.poll, collision, [&](long step) {
    if (observation.observer && (step % observation.every == 0 || collision.over())) {
      collision.show(observation.observer);
    }
  });
  if (!rest) return std::nullopt;
  return collision.result(*rest);
}

/// An oblique impact of bodies in which both directions act on each other, as disks (CoupledCollision).
/// @param along the contact against forces along the surface, of both parities (contacts_along)
/// @throws as oblique_impact; InvalidInput for the quasistatic tail, on which friction flutters; NotConverged where no
///         forces obey Coulomb's law
ObliqueImpact coupled_impact(const Contact& contact, const std::vector<Contact>& along, double speed,
                             const Obliquity& obliquity, const ImpactOptions& options,
                             const ObliqueObservation& observation) {
  FixedResolution resolution = fixed_resolution(contact, speed, options.resolution);
  if (resolution.tail != Tail::radiating) {
    throw InvalidInput::out_of_range("tail", "the static one with friction", "the radiating one",
                                     "friction flutters on it");
  }
  if (options.start) require_start(*options.start, speed);
  const ObliqueFrame frame(contact, speed, options);
  ObliqueImpact result = on_a_grid_that_suffices(contact, resolution, [&](const FixedResolution& each) {
    return run_once(contact, along, frame, obliquity, each, options, {});
  });
  require_resolved(result.energy_error);
  require_known_for(contact, result.normal.contact_time);
  // As `impact`: what is watched is a repetition on the grid that is known to suffice.
  if (observation.observer) {
    result = *run_once(contact, along, frame, obliquity, resolution, options, observation);
  }
  fill_inputs(contact, speed, resolution, options, result.normal);
  return result;
}

}  // namespace

ObliqueImpact oblique_impact(const Contact& contact, double speed, const Obliquity& obliquity,
                             const ImpactOptions& options, const ObliqueObservation& observation) {
  const ObliqueFrame frame(contact, speed, options);
  frame.require(obliquity);
  require_every(observation.every);
  if (obliquity.friction > 0.0) {
    // Rings that move in one direction do not mix it with the normal one.
    if (contact.first->contour == Contour::ball) {
      return SharedNormalImpact(contact, speed, options).with(obliquity, options.poll, observation);
    }
    return coupled_impact(contact, contacts_along(contact, options.poll), speed, obliquity, options, observation);
  }
  if (observation.observer) return smooth_impact({contact, speed, options}, obliquity, observation);
  return frame.joined(impact(contact, speed, options), obliquity, ObliqueFrame::unchanged(obliquity));
}

}  // namespace stoss
