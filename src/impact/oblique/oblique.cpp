#include "stoss/impact/oblique.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "contact/along.hpp"
#include "contact/demands.hpp"
#include "impact/ending.hpp"
#include "impact/inputs.hpp"
#include "impact/oblique/film.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/oblique/sided/oblique_collision.hpp"
#include "impact/recommended.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// One run; empty if the contact outgrew the grid.
std::optional<ObliqueImpact> run_coupled(const Contact& contact, const std::vector<Contact>& along,
                                         const ObliqueFrame& frame, const Obliquity& obliquity,
                                         const FixedResolution& resolution, const ImpactOptions& options,
                                         const ObliqueObservation& observation) {
  const ContactGrid grid = contact_grid(contact, resolution.half_width, resolution.nodes);
  ObliqueCollision collision(contact, along, resolution, grid, frame, obliquity, options.start, options.poll);
  const double flight = std::max(0.0, -collision.compression()) + 4.0 * collision.clearance();
  double steps = (longest_duration(contact) + flight / frame.speed) / resolution.step;
  if (observation.observer) collision.show(observation.observer);
  Rest rest(contact, frame.speed, steps);
  for (long step = 1; !collision.over(); ++step) {
    if (static_cast<double>(step) > steps) {
      if (rest.ends(collision.slowing())) break;
      if (contact.unbounded) throw Outlasted(static_cast<double>(step) * resolution.step, echo_time(contact));
      steps += collision.steps_to_leave();
    }
    if (static_cast<double>(step) > std::min(steps, most_steps)) {
      throw NotConverged("impact: the contact has not ended after " + std::to_string(step) + " steps");
    }
    if (options.poll) options.poll();
    collision.advance();
    rest.watch(step, [&] { return collision.slowing(); });
    if (collision.overflows()) {
      if (resolution.half_width < greatest_half_width(contact)) return std::nullopt;
      throw NotConverged("impact: the contact spreads over the whole body (speed too high for this model)");
    }
    if (observation.observer && (step % observation.every == 0 || collision.over())) {
      collision.show(observation.observer);
    }
  }
  return collision.result(rest);
}

/// An oblique impact of bodies in which both directions act on each other, as disks (ObliqueCollision).
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
  std::optional<ObliqueImpact> result = run_coupled(contact, along, frame, obliquity, resolution, options, {});
  while (!result) {
    resolution = widened(contact, resolution);
    result = run_coupled(contact, along, frame, obliquity, resolution, options, {});
  }
  require_resolved(result->energy_error);
  if (result->normal.contact_time > echo_time(contact)) {
    throw Outlasted(result->normal.contact_time, echo_time(contact));
  }
  // As `impact`: what is watched is a repetition on the grid that is known to suffice.
  if (observation.observer) {
    result = run_coupled(contact, along, frame, obliquity, resolution, options, observation);
  }
  show_inputs(contact, speed, resolution, options, result->normal);
  return std::move(*result);
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
      return Slides(contact, speed, options).after(obliquity, options.poll, observation);
    }
    return coupled_impact(contact, contacts_along(contact, options.poll), speed, obliquity, options, observation);
  }
  if (observation.observer) return smooth_impact({contact, speed, options}, obliquity, observation);
  return frame.joined(impact(contact, speed, options), obliquity, ObliqueFrame::unchanged(obliquity));
}

}  // namespace stoss
