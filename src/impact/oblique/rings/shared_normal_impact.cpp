// The motion along the surface under the pressures of a normal impact that many obliquities share.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "contact/along.hpp"
#include "contact/friction.hpp"
#include "impact/oblique/film.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/oblique/rings/normal_course.hpp"
#include "impact/oblique/rings/tangential_impact.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/oblique.hpp"

namespace stoss {
namespace {

Contact contact_along(const Contact& contact, const Poll& poll) {
  std::vector<Contact> along = contacts_along(contact, poll);
  if (along.size() == 1) return std::move(along.front());
  throw InvalidInput::out_of_range(
      "contact", "'" + name(contact) + "'",
      "bodies whose motions along the normal and along the surface do not act on each other, as spheres",
      "compute each oblique impact by itself");
}

/// @throws NotConverged where the motion along the surface is not resolved in time and means nothing: energy is
/// missing, or comes out of what can only take it
void require_resolved(const ObliqueImpact& impact) {
  constexpr double most = 1e-2;
  const ObliqueLedger& energy = impact.energy;
  const double missing = std::max({std::abs(impact.energy_error), -energy.friction, -energy.unresolved});
  if (missing <= most) return;
  throw NotConverged(
      "impact: " + std::to_string(missing) + " of the energy is unaccounted for in the motion along the surface",
      "step", "use a smaller step");
}

}  // namespace

struct SharedNormalImpact::Parts {
  // The contact along the surface is asked for first: it refuses at once what has no answer there.
  Parts(const Contact& contact, const Contact& along, double speed, const ImpactOptions& options)
      : course(contact, speed, options),
        response(contact, along, course.nodes, course.impact.resolution, course.pressures.steps(), options.poll) {}

  NormalCourse course;
  TangentialResponse response;
};

SharedNormalImpact::SharedNormalImpact(const Contact& contact, double speed, const ImpactOptions& options)
    : parts_(std::make_shared<const Parts>(contact, contact_along(contact, options.poll), speed, options)) {}

const Impact& SharedNormalImpact::normal() const { return parts_->course.impact; }

ObliqueImpact SharedNormalImpact::with(const Obliquity& obliquity, const Poll& poll,
                                       const ObliqueObservation& observation) const {
  const NormalCourse& course = parts_->course;
  const TangentialResponse& response = parts_->response;
  const Pressures& pressures = course.pressures;
  course.frame.require(obliquity);
  if (obliquity.friction == 0.0) return smooth_impact(course, obliquity, observation);
  ObliqueFilm film(course, obliquity, observation);
  film.fly(pressures.first() - 1, {ObliqueFrame::unchanged(obliquity)});
  TangentialImpact motion(response, course.frame, obliquity);
  const std::size_t nodes = course.nodes.count;
  Friction coulomb(nodes);
  std::vector<double> limit(nodes);
  for (std::size_t step = 0; step < pressures.steps(); ++step) {
    if (poll) poll();
    std::transform(pressures.force(step), pressures.force(step) + nodes, limit.begin(),
                   [&](double pressure) { return obliquity.friction * pressure; });
    motion.advance(pressures.give(step), pressures.extent(step), [&](const auto& give, const auto& free, auto& force) {
      coulomb.solve(response.compliance, give, free, limit.data(), force);
    });
    if (!film.advance()) continue;
    std::vector<PointFriction> point_friction = motion.point_friction();
    for (std::size_t i = 0; i < nodes; ++i) point_friction[i].sliding = coulomb.sliding()[i];
    film.show(motion.motion(), point_friction);
  }
  const AlongMotion end = motion.motion();
  film.fly(course.impact.steps, end);
  const double momentum = course.mass * course.impact.final_state.velocity;
  ObliqueImpact result = course.frame.joined(course.impact, obliquity, end.outcome, momentum);
  require_resolved(result);
  return result;
}

}  // namespace stoss
