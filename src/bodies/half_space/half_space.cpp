// Half-space and half-plane as bodies: the waves of the surface are their modes, which all move it alike along k.
#include "stoss/bodies/half_space.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bodies/half_space/plane/bodies_along.hpp"
#include "bodies/half_space/residual.hpp"
#include "bodies/half_space/surface_waves.hpp"
#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using namespace bodies::half_space;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_waves = 2e6;

/// A half-space or a half-plane.
struct Solid {
  Contour contour;
  double poisson, young, density, loss_time;

  /// η in its own unit of time.
  [[nodiscard]] double own_loss_time() const { return loss_time * std::sqrt(young / density); }
};

Solid solid(const HalfSpace& given) {
  return {Contour::ball, given.poisson, given.young, given.density, given.loss_time};
}

Solid solid(const HalfPlane& given) {
  return {Contour::cylinder, given.poisson, given.young, given.density, given.loss_time};
}

void require_solid(const Solid& given) {
  require_poisson(given.contour, given.poisson);
  constexpr Range positive{0.0, std::numeric_limits<double>::max(), false, true, "a positive finite number"};
  require("young", given.young, positive, "Young's modulus of the half-space");
  require("density", given.density, positive, "of the half-space");
  require_loss_time(given.own_loss_time());
}

std::string name_of(const Solid& given) {
  std::string name = given.contour == Contour::ball ? "half-space" : "half-plane";
  name += " poisson=" + shown(given.poisson);
  if (given.young != 1.0) name += " young=" + shown(given.young);
  if (given.density != 1.0) name += " density=" + shown(given.density);
  if (given.loss_time != 0.0) name += " loss_time=" + shown(given.loss_time);
  return name;
}

Surface make_surface(const Medium& medium, const std::vector<SurfaceWaves>& all, const ContactPoints& points) {
  Surface surface;
  for (std::size_t i = 0; i < points.count; ++i) {
    const double inner = points.radius * std::sin(static_cast<double>(i) * points.spacing);
    const double outer = points.radius * std::sin(static_cast<double>(i + 1) * points.spacing);
    const double measure = medium.measure(inner, outer);
    surface.recess.push_back(0.0);
    surface.measure.push_back(measure);
    surface.impedance.push_back(measure * medium.leaving_speed);
  }
  for (const SurfaceWaves& waves : all) {
    for (std::size_t i = 0; i < points.count; ++i) {
      surface.shape.push_back(medium.shape(waves.wave_number * lateral_distance(points, i)));
    }
  }
  return surface;
}

/// Chosen as for spheres, of which fewer modes matter (docs/numerics.md, section 5).
constexpr Sampling sampling_of_balls{.points = 48.0, .cutoff = 8.0, .power = 0.5, .along_edge = 0.0, .fewest = 32};
constexpr Sampling sampling_of_disks{.points = 48.0, .cutoff = 8.0, .power = 0.5, .along_edge = 0.0, .fewest = 32};

Body made(const Solid& given, double cutoff, double duration, Direction direction, const Poll& poll) {
  require_solid(given);
  constexpr Range positive{0.0, std::numeric_limits<double>::max(), false, true, "a positive finite number"};
  require("cutoff", cutoff, positive, "highest frequency of the half-space");
  require("duration", duration, positive, "longest contact with the half-space");
  const Medium medium = bodies::half_space::medium(given.contour, given.poisson, direction);
  const double loss_time = given.own_loss_time(), highest = kept_cutoff(cutoff, loss_time);
  const double most = cutoff_of_count(medium, most_waves, duration);
  if (highest > most) {
    throw InvalidInput("cutoff: got " + shown(cutoff) + " of a half-space for contacts of " + shown(duration) +
                       " in its own time, allowed a smaller product (more waves than are computed)");
  }
  const auto waves = std::make_shared<const std::vector<SurfaceWaves>>(surface_waves(medium, highest, duration, poll));
  Body body;
  body.name = name_of(given);
  body.scale = {1.0, std::sqrt(given.young / given.density), given.density};
  body.contour = given.contour;
  body.curvature = 0.0;
  body.mass = 1.0;
  body.part = {1.0, infinity, duration};
  body.softness = medium.softness;
  body.loss_time = loss_time;
  body.cutoff = cutoff;
  body.highest_cutoff = loss_time * most > 1.0 ? infinity : most;
  body.sampling = given.contour == Contour::ball ? sampling_of_balls : sampling_of_disks;
  if (given.contour == Contour::cylinder) {
    body.along = [like = body, medium, duration](const Poll& heed) {
      return planes_along(like, medium, duration, heed);
    };
  } else if (direction == Direction::normal) {
    body.along = [given, cutoff, duration](const Poll& heed) {
      return std::vector<Body>{made(given, cutoff, duration, Direction::along, heed)};
    };
    body.outward = [like = body, medium, duration](const Poll& heed) {
      return space_outward(like, medium, duration, heed);
    };
  }
  for (const SurfaceWaves& each : *waves) {
    const std::size_t row = body.groups.size();
    ModeGroup group{static_cast<int>(row), each.omega, {}, std::vector<double>(each.omega.size()), row, row, {},
                    each.wave_number};
    for (const double strength : each.strength) group.upper.push_back(std::sqrt(strength));
    body.groups.push_back(std::move(group));
  }
  body.surface = [medium, waves](const ContactPoints& points) { return make_surface(medium, *waves, points); };
  const auto residual = std::make_shared<const Residual>(medium, highest, waves);
  body.stable_step = residual->stable_step();
  body.residual_compliance = [residual](const ContactPoints& points, const Poll& heed) {
    return residual->compliance(points, heed);
  };
  body.residual_second_moment = [residual](const ContactPoints& points, const Poll& heed) {
    return residual->second_moment(points, heed);
  };
  if (direction == Direction::along) return body;
  body.near_side = [given](double longest, double limit, const Poll& heed) {
    return made(given, limit, longest, Direction::normal, heed);
  };
  return body;
}

BodyMaker maker(const Solid& given) {
  require_solid(given);
  constexpr double usual_duration = 10.0;  // of a fast impact
  return
      [given](double cutoff, const Poll& poll) { return made(given, cutoff, usual_duration, Direction::normal, poll); };
}

}  // namespace

Body half_space(const HalfSpace& half_space, double cutoff, double duration, const Poll& poll) {
  return made(solid(half_space), cutoff, duration, Direction::normal, poll);
}

Body half_plane(const HalfPlane& half_plane, double cutoff, double duration, const Poll& poll) {
  return made(solid(half_plane), cutoff, duration, Direction::normal, poll);
}

BodyMaker half_space(const HalfSpace& half_space) { return maker(solid(half_space)); }

BodyMaker half_plane(const HalfPlane& half_plane) { return maker(solid(half_plane)); }

}  // namespace stoss
