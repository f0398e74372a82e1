// A body of which only a point is known: its kept modes move the contact as u(r) = φ + χ r², and what is left of it is
// that of a sphere of its curvature, or of a half-space, with its own c₀.
#include "stoss/bodies/modal_body.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>

#include "bodies/half_space/surface_waves.hpp"
#include "bodies/modal/point_compliance.hpp"
#include "bodies/modal/point_modes.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/surface_points.hpp"
#include "bodies/surface/residual.hpp"
#include "check.hpp"
#include "stoss/bodies/half_space.hpp"

namespace stoss {
namespace {

using namespace bodies;
using bodies::modal::PointModes;

/// Chosen as for spheres (docs/numerics.md, section 5).
constexpr Sampling sampling{.points = 40.0, .cutoff = 32.0, .power = 0.7, .along_edge = 0.0, .fewest = 32};

/// ω_c a, c, up to which modes that bend, or move the contact as a piston, leave a compliance that is positive, and
/// lose what those of a sphere lose (docs/theory/any_body.md).
constexpr double reach = 1.1, reach_of_pistons = 0.6;

/// Duration for which the quadrature of the half-space that gives V is made, own_length/c.
constexpr double local_duration = 6.0;

double own_speed(const ModalBody& body) { return std::sqrt(body.young / body.density); }

/// The surface at the point, with the rows 1 and r².
Surface surface_of(double poisson, bool plane, const ContactPoints& points) {
  Surface surface = sphere::axial_surface(poisson, 0, points);
  if (plane) {
    const half_space::Medium medium = half_space::medium(Contour::ball, poisson);
    for (std::size_t i = 0; i < points.count; ++i) {
      const double inner = points.radius * std::sin(static_cast<double>(i) * points.spacing);
      const double outer = points.radius * std::sin(static_cast<double>(i + 1) * points.spacing);
      surface.recess[i] = 0.0;
      surface.measure[i] = medium.measure(inner, outer);
      surface.impedance[i] = surface.measure[i] * medium.leaving_speed;
    }
  }
  surface.shape.assign(points.count, 1.0);
  for (std::size_t i = 0; i < points.count; ++i) {
    const double distance = lateral_distance(points, i);
    surface.shape.push_back(distance * distance);
  }
  return surface;
}

/// Static compliance of the surroundings of the point, without the constant of the whole body.
std::vector<double> local_compliance(double poisson, bool plane, const ContactPoints& points, const Poll& poll) {
  if (plane) {
    const auto none = std::make_shared<const std::vector<SurfaceWaves>>();
    return WaveResidual(half_space::medium(Contour::ball, poisson), 1.0, 0.0, none).compliance(points, poll);
  }
  std::vector<double> compliance = sphere::sum_over_degrees({{poisson, true, {}}}, points, poll);
  const double constant = modal::sphere_constant(poisson);
  for (double& each : compliance) each -= constant;
  return compliance;
}

/// Takes the kept modes from a static compliance.
void take_kept(const PointModes& modes, const ContactPoints& points, std::vector<double>& matrix) {
  std::vector<double> row(points.count);
  for (const modal::KeptMode& mode : modes.kept) {
    const double weight = 1.0 / (modes.mass * mode.omega * mode.omega);
    for (std::size_t i = 0; i < points.count; ++i) {
      const double distance = lateral_distance(points, i);
      row[i] = mode.displacement + mode.bend * distance * distance;
    }
    for (std::size_t i = 0; i < points.count; ++i) {
      for (std::size_t j = 0; j < points.count; ++j) matrix[i * points.count + j] -= weight * row[i] * row[j];
    }
  }
}

/// The body with one kind of its numbers off by their errors, if they have any.
std::vector<ModalBody> alternatives(const ModalBody& its, double other) {
  std::vector<ModalBody> all;
  if (its.compliance_error > 0.0) {
    all.push_back(its);
    all.back().compliance += its.compliance_error;
  }
  const auto with = [&](auto change) {
    all.push_back(its);
    for (PointMode& mode : all.back().modes) change(mode);
  };
  const auto any = [&](double PointMode::*error) {
    return std::any_of(its.modes.begin(), its.modes.end(),
                       [error](const PointMode& mode) { return mode.*error > 0.0; });
  };
  if (any(&PointMode::omega_error)) with([](PointMode& mode) { mode.omega += mode.omega_error; });
  if (any(&PointMode::displacement_error)) {
    with([](PointMode& mode) { mode.displacement += std::copysign(mode.displacement_error, mode.displacement); });
  }
  if (!its.has_bends) {  // as of Rayleigh waves of their frequency
    const double slowest = half_space::medium(Contour::ball, its.poisson).rayleigh_speed() * own_speed(its);
    with([slowest](PointMode& mode) { mode.bend = -0.25 * mode.displacement * std::pow(mode.omega / slowest, 2); });
  }
  if (its.curvature_difference > 0.0) {
    // Of Hertz' ellipses up to 4 : 1 the curvature counts that is A B (A + B)/2, cubed, with the relative ones A, B.
    all.push_back(its);
    const double mean = its.curvature + other / own_length(its), half = 0.5 * its.curvature_difference;
    all.back().curvature -= mean - std::cbrt((mean * mean - half * half) * mean);
    all.back().curvature_difference = 0.0;  // round, or its own ratio may be refused
  }
  return all;
}

Body made(const ModalBody& its, double cutoff) {
  const double length = own_length(its);
  const PointModes modes = modal::point_modes(its, kept_cutoff(cutoff, its.loss_time * own_speed(its) / length));
  const bool plane = its.curvature == 0.0;
  Body body;
  body.name = its.name;
  body.scale = {length, own_speed(its), its.mass};
  body.contour = Contour::ball;
  body.mass = modes.mass;
  body.extent = 1.0;
  body.curvature = plane ? 0.0 : 1.0;
  body.curvature_difference = its.curvature_difference * length;
  body.softness = 1.0 - its.poisson * its.poisson;
  body.loss_time = its.loss_time * own_speed(its) / length;
  body.cutoff = cutoff;
  body.sampling = sampling;
  body.known.complete_to = its.complete_to * length / own_speed(its);
  body.known.reach = its.has_bends ? reach : reach_of_pistons;
  // By what lies further off on a curved surface, of which the two radii say nothing.
  if (!plane) body.known.neglected = [](double half_width) { return half_width * half_width; };
  body.known.alternatives = [its, cutoff](double other) {
    std::vector<Body> bodies;
    for (const ModalBody& each : alternatives(its, other)) {  // the same cutoff, in units of their length
      bodies.push_back(made(each, cutoff * own_length(each) / own_length(its)));
    }
    return bodies;
  };
  ModeGroup group{0, {}, {}, {}, 0, 1, {}, 0.0};
  for (const modal::KeptMode& mode : modes.kept) {
    group.omega.push_back(mode.omega);
    group.upper.push_back(mode.displacement);
    group.lower.push_back(mode.bend);
  }
  if (!group.omega.empty()) body.groups.push_back(std::move(group));
  const double poisson = its.poisson;
  body.surface = [poisson, plane](const ContactPoints& points) { return surface_of(poisson, plane, points); };
  body.residual_compliance = [poisson, plane, modes](const ContactPoints& points, const Poll& poll) {
    std::vector<double> compliance = local_compliance(poisson, plane, points, poll);
    for (double& each : compliance) each += modes.constant;
    take_kept(modes, points, compliance);
    return compliance;
  };
  // V of the waves above the cutoff is that of a half-space: they do not know how the body ends.
  body.residual_second_moment = [poisson, cutoff](const ContactPoints& points, const Poll& poll) {
    return stoss::half_space(HalfSpace{poisson}, cutoff, local_duration, poll).residual_second_moment(points, poll);
  };
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
  }
  return same;
}

Scales scales(const ModalBody& body) {
  modal::require_body(body);
  const double length = own_length(body), speed = own_speed(body);
  return {length, speed, length / speed, speed / length, body.mass * speed * speed / length};
}

BodyMaker modal_body(ModalBody body) {
  modal::require_body(body);
  const auto its = std::make_shared<const ModalBody>(std::move(body));
  return [its](double cutoff, const Poll&) { return made(*its, cutoff); };
}

}  // namespace stoss
