// A sphere as a body, solid or hollow: its modes by degree, the shapes of the degrees on its surface, and the response
// of the others.
//
// A mode moves the ring at θ towards the wall by Q (U P_n cos θ − V dP_n/dθ sin θ) = Q (p P_{n+1} + q P_{n−1}) with
// p = (n+1)(U − nV)/(2n+1), q = n(U + (n+1)V)/(2n+1).
#include "stoss/bodies/sphere.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bodies/round_body.hpp"
#include "bodies/sphere/along/along.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/hole/hole.hpp"
#include "bodies/sphere/hole/radial_shell.hpp"
#include "bodies/sphere/legendre.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "bodies/sphere/surface_points.hpp"
#include "check.hpp"
#include "stoss/bodies/hollow_sphere.hpp"
#include "stoss/bodies/sphere/modes.hpp"

namespace stoss {
namespace {

using namespace bodies::sphere;

// The lowest mode lies between these for every ν.
constexpr double no_mode_below = 1.0;
constexpr double highest_lowest_mode = 2.0;
constexpr double mass = 4.0 * std::numbers::pi / 3.0;

/// @param unit amplitude of a mode of the mass of the body, over that of one of the mass of a solid sphere
std::vector<ModeGroup> group_by_degree(const std::vector<Mode>& modes, double unit) {
  std::vector<ModeGroup> groups;
  for (const Mode& mode : modes) {
    const double n = mode.order;
    if (groups.empty() || groups.back().order != mode.order) {
      const auto row = static_cast<std::size_t>(mode.order);
      groups.push_back({mode.order, {}, {}, {}, row + 1, row > 0 ? row - 1 : 1, {}, n});
    }
    groups.back().omega.push_back(mode.omega);
    groups.back().upper.push_back(unit * (n + 1.0) / (2.0 * n + 1.0) * (mode.radial - n * mode.tangential));
    groups.back().lower.push_back(unit * n / (2.0 * n + 1.0) * (mode.radial + (n + 1.0) * mode.tangential));
  }
  return groups;
}

void require_sphere(const Sphere& sphere) {
  bodies::sphere::require_poisson(sphere.poisson);
  bodies::require_size_and_material("sphere", sphere);
}

/// Chosen so that steps, rings and modes are refined together (docs/developer/numerics.md, section 5).
constexpr Sampling sampling{.points = 40.0, .cutoff = 32.0, .power = 0.7, .along_edge = 0.0, .fewest = 32};

/// What a lossy sphere loses is as accurate as its modes with twice the rings.
constexpr Sampling sampling_of_losses{.points = 80.0, .cutoff = 32.0, .power = 0.7, .along_edge = 0.0, .fewest = 64};

/// The sphere, with a hole in it perhaps, of which these are the modes.
Body made(const Sphere& sphere, double cutoff, const Kept& kept, const Poll& poll) {
  const double poisson = sphere.poisson, loss_time = bodies::own_loss_time(sphere), inner = kept.hole.inner();
  const std::vector<Mode>& modes = *kept.modes;
  Body body;
  body.name =
      inner > 0.0 ? bodies::name_of("hollow sphere inner=" + shown(inner), sphere) : bodies::name_of("sphere", sphere);
  body.contour = Contour::ball;
  body.mass = mass * share_of_mass(inner);
  body.scale = {sphere.radius, bodies::wave_speed(sphere),
                body.mass * sphere.density * sphere.radius * sphere.radius * sphere.radius};
  body.extent = 1.0;
  body.hole = inner;
  body.softness = 1.0 - poisson * poisson;
  body.inertia = 0.4 * mass * share_of_inertia(inner);
  body.loss_time = loss_time;
  body.cutoff = cutoff;
  body.highest_cutoff = inner > 0.0 ? max_hollow_cutoff : max_cutoff;
  body.sampling = loss_time > 0.0 ? sampling_of_losses : sampling;
  body.groups = group_by_degree(modes, std::sqrt(share_of_mass(inner)));
  const std::size_t rows = modes.empty() ? 0 : static_cast<std::size_t>(modes.back().order) + 2;
  body.surface = [poisson, rows](const ContactPoints& points) { return axial_surface(poisson, rows, points); };
  bodies::set_residual(body, std::make_shared<const Residual>(poisson, cutoff, modes, kept.hole.excess(poll)));
  body.along = [sphere, cutoff, kept](const Poll& heed) {
    return std::vector<Body>{along(made(sphere, cutoff, kept, heed), sphere.poisson, kept, heed)};
  };
  body.outward = [sphere, cutoff, kept](const Poll& heed) {
    return outward(made(sphere, cutoff, kept, heed), sphere.poisson, kept, heed);
  };
  return body;
}

Body made(const Sphere& sphere, const Hole& hole, double cutoff, const Poll& poll) {
  const double highest = kept_cutoff(cutoff, bodies::own_loss_time(sphere));
  const bool none = hole.inner() == 0.0 && highest <= no_mode_below;
  std::vector<Mode> modes = none ? std::vector<Mode>{} : hole.modes(sphere.poisson, highest, poll);
  return made(sphere, cutoff, {std::make_shared<const std::vector<Mode>>(std::move(modes)), hole}, poll);
}

Sphere solid(const HollowSphere& hollow) {
  return {hollow.poisson, hollow.radius, hollow.young, hollow.density, hollow.loss_time};
}

void require_hollow(const HollowSphere& hollow) {
  require_sphere(solid(hollow));
  require_inner(hollow.inner);
}

}  // namespace

void bodies::sphere::require_inner(double inner) {
  constexpr Range allowed{0.0, max_inner, true, true, "0 to 0.99"};
  require("inner", inner, allowed, "radius of the hole over that of the sphere");
}

Surface bodies::sphere::axial_surface(double poisson, std::size_t rows, const ContactPoints& points) {
  const WaveSpeeds speed = wave_speeds(poisson);
  Surface surface;
  Eigen::ArrayXd angle(static_cast<Eigen::Index>(points.count));
  for (std::size_t i = 0; i < points.count; ++i) {
    const double theta = ring_angle(points, i);
    angle(static_cast<Eigen::Index>(i)) = theta;
    const double area = ring_area(points, i), cosine = std::cos(theta), sine = std::sin(theta);
    surface.recess.push_back(2.0 * std::sin(0.5 * theta) * std::sin(0.5 * theta));
    surface.measure.push_back(area);
    surface.impedance.push_back(area / (cosine * cosine / speed.pressure + sine * sine / speed.shear));
  }
  LegendreSequence sequence(angle);
  for (std::size_t n = 0; n < rows; ++n, sequence.advance()) {
    surface.shape.insert(surface.shape.end(), sequence.value().begin(), sequence.value().end());
  }
  return surface;
}

Scales scales(const Sphere& sphere) {
  require_sphere(sphere);
  const double speed = bodies::wave_speed(sphere);
  return {sphere.radius, speed, sphere.radius / speed, speed / sphere.radius,
          mass * sphere.radius * sphere.radius * sphere.young};
}

Body sphere(const Sphere& sphere, double cutoff, const Poll& poll) {
  require_sphere(sphere);
  constexpr Range allowed{0.0, max_cutoff, false, true, "above 0 to 1000"};
  require("cutoff", cutoff, allowed, "highest frequency in c/R of this sphere; 25 to 100 is usual");
  return made(sphere, Hole{}, cutoff, poll);
}

Body sphere(double poisson, double cutoff, const Poll& poll) {
  // By itself, a sphere without modes is a mistake.
  if (cutoff < highest_lowest_mode) (void)bodies::sphere::modes(poisson, cutoff);
  return sphere(Sphere{poisson}, cutoff, poll);
}

BodyMaker sphere(const Sphere& sphere) {
  require_sphere(sphere);
  return [sphere](double cutoff, const Poll& poll) { return stoss::sphere(sphere, cutoff, poll); };
}

BodyMaker sphere(double poisson) { return sphere(Sphere{poisson}); }

Scales scales(const HollowSphere& hollow) {
  require_hollow(hollow);
  Scales its = scales(solid(hollow));
  its.force *= share_of_mass(hollow.inner);
  return its;
}

BodyMaker hollow_sphere(const HollowSphere& hollow) {
  require_hollow(hollow);
  if (hollow.inner == 0.0) return sphere(solid(hollow));
  return [hollow, hole = Hole(hollow.poisson, hollow.inner)](double cutoff, const Poll& poll) {
    constexpr Range allowed{0.0, max_hollow_cutoff, false, true, "above 0 to 400"};
    require("cutoff", cutoff, allowed, "highest frequency in c/R of this hollow sphere; 25 to 100 is usual");
    return made(solid(hollow), hole, cutoff, poll);
  };
}

}  // namespace stoss
