// The part is a disk with units R_p = size · R, c and ρR_p² of its own: its times are `size` times those of the whole
// and its masses size² times, so that compliances t²/m are the same, and second moments t⁴/m size² times.
#include "bodies/disk/near_side.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "bodies/disk/edge_points.hpp"
#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Points as the part sees them, in its units.
ContactPoints seen_by_part(const ContactPoints& points, double size) {
  const ContactPoints seen{points.radius / size, points.spacing, points.count};
  if (points.count > 0 && !(seen.radius * std::sin(seen.angle(points.count - 1)) < 1.0)) {
    throw NotConverged("contact: it spreads over more than the near side of the larger body (speed too high)");
  }
  return seen;
}

/// Surface of the part in units of the whole, with the contour of the whole.
Surface whole_surface(Surface surface, const ContactPoints& points, double size) {
  for (std::size_t i = 0; i < surface.recess.size(); ++i) {  // of one or both components
    const double sine = std::sin(0.5 * bodies::disk::edge_angle(points, i % points.count));
    surface.recess[i] = 2.0 * sine * sine;
    surface.measure[i] *= size;
    surface.impedance[i] *= size;
  }
  return surface;
}

/// The part as a body in the units of the whole.
Body part_of_whole(const std::shared_ptr<const Body>& part, double size, double cutoff, double echo) {
  Body body = *part;
  body.mass = part->mass * size * size;
  body.scale.mass *= size * size;
  body.part = {size, part->mass - body.mass, echo};
  body.inertia *= size * size * size * size;
  body.cutoff = cutoff;
  body.loss_time *= size;
  body.highest_cutoff = part->highest_cutoff / size;
  body.stable_step *= size;
  for (ModeGroup& group : body.groups) {
    group.wave_number /= size;
    for (double& omega : group.omega) omega = std::min(omega / size, kept_cutoff(body));  // rounding
  }
  body.surface = [part, size](const ContactPoints& points) {
    return whole_surface(part->surface(seen_by_part(points, size)), points, size);
  };
  body.residual_compliance = [part, size](const ContactPoints& points, const Poll& heed) {
    return part->residual_compliance(seen_by_part(points, size), heed);
  };
  body.residual_second_moment = [part, size](const ContactPoints& points, const Poll& heed) {
    std::vector<double> moment = part->residual_second_moment(seen_by_part(points, size), heed);
    for (double& each : moment) each *= size * size;
    return moment;
  };
  body.near_side = nullptr;
  return body;
}

}  // namespace

Body near_side(const Disk& disk, double size, double cutoff, const Poll& poll) {
  require("size", size, {0.0, 1.0, false, true, "above 0 to 1"}, "of the near side of a disk, in its radius");
  Disk like = disk;
  like.loss_time /= size;
  const auto part = std::make_shared<const Body>(stoss::disk(like, cutoff * size, poll));
  const double echo = 4.0 * size * std::sqrt(1.0 - disk.poisson * disk.poisson);
  Body body = part_of_whole(part, size, cutoff, echo);
  body.along = [part, size, cutoff, echo](const Poll& heed) {
    std::vector<Body> bodies;
    for (Body& each : part->along(heed)) {
      bodies.push_back(part_of_whole(std::make_shared<const Body>(std::move(each)), size, cutoff, echo));
    }
    return bodies;
  };
  return body;
}

}  // namespace stoss
