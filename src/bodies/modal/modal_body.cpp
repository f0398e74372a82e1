// A body of which only a point is known: its kept modes move the contact as u(r) = φ + χ r², and what is left of it is
// that of a sphere of its curvature, or of a half-space, with its own c₀.
#include "stoss/bodies/modal_body.hpp"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "bodies/modal/along.hpp"
#include "bodies/modal/alternatives.hpp"
#include "bodies/modal/point_modes.hpp"
#include "bodies/surface/residual.hpp"
#include "stoss/bodies/half_space.hpp"

namespace stoss {
namespace {

using namespace bodies;
using bodies::modal::Bending;
using bodies::modal::Direction;
using bodies::modal::PointModes;
using bodies::modal::PointSurroundings;
using bodies::modal::Unevenness;
using bodies::modal::wave_speed;

/// Chosen as for spheres (docs/developer/numerics.md, section 5).
constexpr Sampling sampling{.points = 40.0, .cutoff = 32.0, .power = 0.7, .along_edge = 0.0, .fewest = 32};

/// Duration for which the quadrature of the half-space that gives V is made, own_length/c.
constexpr double local_duration = 6.0;

/// What a number of a body is worth: as it is given, or off by an error, of which nothing is refused.
enum class Numbers { given, off };

Body made(const ModalBody& its, double cutoff, Numbers numbers, const Bending& bends, const Unevenness& uneven = {});

/// The bodies with these numbers at the same cutoff, which is in units of their length.
std::vector<Body> made_all(const modal::Alternatives& all, const ModalBody& its, double cutoff, const Bending& bends) {
  std::vector<Body> bodies;
  const auto add = [&](const std::vector<ModalBody>& each, bool bound) {
    for (const ModalBody& other : each) {
      bodies.push_back(made(other, cutoff * own_length(other) / own_length(its), Numbers::off, bends));
      bodies.back().known.is_bound = bound;
    }
  };
  add(all.errors, false);
  add(all.bounds, true);
  return bodies;
}

/// The body with another surface of the same curvature, recessed by ¼ H³r⁴ more: a cylinder is, beside a sphere of its
/// mean curvature, and less by half of it a paraboloid. A point tells none of them from the others, and in (Ha)² they
/// differ by nothing else (docs/theory/any_body.md). A saddle has that of a cylinder of its greater curvature.
Body flatter_sided(Body body) {
  body.known.is_bound = true;
  const double bent = std::max(1.0, 0.5 * (1.0 + 0.5 * body.curvature_difference));
  body.surface = [round = body.surface, of_a_cylinder = 0.25 * bent * bent * bent](const ContactPoints& points) {
    Surface surface = round(points);
    for (std::size_t i = 0; i < points.count; ++i) {
      const double distance = lateral_distance(points, i);
      surface.recess[i] += of_a_cylinder * std::pow(distance, 4);
    }
    return surface;
  };
  return body;
}

/// The body with as much more bending as is in doubt.
Body bent(const ModalBody& its, double cutoff, const Bending& bends) {
  Body body = made(its, cutoff, Numbers::off, {bends.constant + bends.doubt, 0.0});
  body.known.is_bound = true;
  return body;
}

Validity knowledge_of(const ModalBody& its, double cutoff, const PointModes& modes, const Bending& bends) {
  Validity known;
  known.complete_to = its.complete_to * own_length(its) / wave_speed(its);
  known.max_cutoff_times_width = its.has_bends ? modal::reach : modal::reach_of_pistons;
  known.max_cutoff_times_width_along =
      its.tangent && its.tangent->has_bends ? known.max_cutoff_times_width : modal::reach_of_pistons;
  known.alternatives = [its, cutoff, bends](double other) {
    std::vector<Body> all = made_all(modal::alternatives(its, other), its, cutoff, bends);
    if (its.curvature > 0.0) all.push_back(flatter_sided(made(its, cutoff, Numbers::off, bends)));
    if (bends.doubt > 0.0) all.push_back(bent(its, cutoff, bends));
    return all;
  };
  known.alternatives_along = [its, cutoff, bends](double other) {
    std::vector<Body> all = made_all(modal::alternatives_along(its), its, cutoff, bends);
    const Unevenness uneven = modal::unevenness(its, other);
    if (its.tangent && uneven.curvature > 0.0) {
      all.push_back(made(its, cutoff, Numbers::off, bends, uneven));
      all.back().known.is_bound = true;
    }
    return all;
  };
  known.cross_mobility = modal::cross_mobility(its, modes);
  return known;
}

/// How friction moves it as a whole.
void set_rigid_motion(const ModalBody& its, Body& body) {
  if (!its.tangent) return;
  const double length = own_length(its), mass = its.density * length * length * length;
  body.mass_along = its.held ? body.mass : its.tangent->mass / mass;
  if (its.held) return;
  if (its.tangent->inertia == 0.0) return;
  body.inertia = its.tangent->inertia / (mass * length * length);
  body.extent = its.tangent->arm / length;
}

Body made(const ModalBody& its, double cutoff, Numbers numbers, const Bending& bends, const Unevenness& uneven) {
  const double length = own_length(its);
  const PointModes modes = modal::point_modes(its, kept_cutoff(cutoff, its.loss_time * wave_speed(its) / length));
  const PointSurroundings near{its.poisson, its.curvature == 0.0};
  Body body;
  body.name = its.name;
  body.scale = {length, wave_speed(its), modal::moving_mass(its)};
  body.held = its.held;
  body.contour = Contour::ball;
  body.mass = modes.mass;
  body.extent = 1.0;
  body.curvature = near.plane ? 0.0 : 1.0;
  body.curvature_difference = its.curvature_difference * length;
  body.softness = 1.0 - its.poisson * its.poisson;
  body.loss_time = its.loss_time * wave_speed(its) / length;
  body.cutoff = cutoff;
  body.sampling = sampling;
  body.known = knowledge_of(its, cutoff, modes, bends);
  set_rigid_motion(its, body);
  body.groups = modal::groups_of(modes, Direction::normal);
  body.surface = [near](const ContactPoints& points) { return modal::point_surface(near, Direction::normal, points); };
  body.residual_compliance = [near, modes, bends](const ContactPoints& points, const Poll& poll) {
    std::vector<double> compliance = modal::local_compliance(near, Direction::normal, points, poll);
    for (double& each : compliance) each += modes.constant;
    if (bends.constant != 0.0) modal::add_bending(bends.constant, points, compliance);
    modal::take_kept(modes, Direction::normal, points, points.count, compliance);
    return compliance;
  };
  // V of the waves above the cutoff is that of a half-space: they do not know how the body ends.
  body.residual_second_moment = [poisson = its.poisson, cutoff](const ContactPoints& points, const Poll& poll) {
    return stoss::half_space(HalfSpace{poisson}, cutoff, local_duration, poll).residual_second_moment(points, poll);
  };
  body.along = [like = body, its, modes, uneven, numbers](const Poll&) {
    if (numbers == Numbers::given) modal::require_apart(its);
    return std::vector<Body>{modal::along(like, its, modes, uneven)};
  };
  body.outward = [like = body, its, modes](const Poll&) { return modal::outward(like, its, modes); };
  return body;
}

}  // namespace

double own_length(const ModalBody& body) {
  return body.curvature > 0.0 ? 1.0 / body.curvature : std::cbrt(body.mass / body.density);
}

ModalBody in_units(const ModalBody& body, double length, double young, double density) {
  const double frequency = std::sqrt(young / density) / length, mass = density * length * length * length;
  const double amplitude = 1.0 / std::sqrt(mass);
  ModalBody same = body;
  same.mass /= mass;
  same.curvature *= length;
  same.curvature_difference *= length;
  same.young /= young;
  same.density /= density;
  same.loss_time *= frequency;
  same.compliance *= young * length;
  same.compliance_error *= young * length;
  same.complete_to /= frequency;
  for (PointMode& mode : same.modes) {
    mode.omega /= frequency;
    mode.omega_error /= frequency;
    mode.displacement /= amplitude;
    mode.displacement_error /= amplitude;
    mode.bend *= length * length / amplitude;
    mode.tangential /= amplitude;
    mode.tangential_error /= amplitude;
    mode.tangential_bend *= length * length / amplitude;
  }
  if (same.tangent) {
    same.tangent->mass /= mass;
    same.tangent->inertia /= mass * length * length;
    same.tangent->arm /= length;
    same.tangent->cross *= mass;
    same.tangent->compliance *= young * length;
    same.tangent->compliance_error *= young * length;
  }
  return same;
}

Scales scales(const ModalBody& body) {
  modal::require_body(body);
  const double length = own_length(body), speed = wave_speed(body);
  return {length, speed, length / speed, speed / length, body.mass * speed * speed / length};
}

BodyMaker modal_body(ModalBody body) {
  modal::require_body(body);
  const auto its = std::make_shared<const ModalBody>(std::move(body));
  return [its, bends = modal::bending(*its, {})](double cutoff, const Poll&) {
    return made(*its, cutoff, Numbers::given, bends);
  };
}

}  // namespace stoss
