// Half-space and half-plane as bodies: the waves of the surface are their modes, which all move it alike along k.
#include "stoss/bodies/half_space.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bodies/half_space/plane/waves.hpp"
#include "bodies/half_space/surface_waves.hpp"
#include "bodies/surface/wave_body.hpp"
#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using namespace bodies;
using namespace bodies::half_space;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_waves = 2e6;

/// A half-space or a half-plane.
struct Solid {
  Contour contour;
  double poisson, young, density, loss_time;

  /// η in its own unit of time.
  [[nodiscard]] double own_loss_time() const { return in_own_time(loss_time, std::sqrt(young / density)); }
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

/// A half-plane against forces along its surface, or a half-space against forces alike all around the axis.
std::vector<Body> plane_bodies_of(const Body& like, const Medium& medium, double duration,
                                  const std::vector<Parity>& parities, const Poll& poll) {
  const double highest = kept_cutoff(like);
  const PlaneSurface surface{medium, highest / medium.rayleigh_speed(),
                             [medium](double k) { return plane_compliance(medium, k); },
                             [medium](double k) { return plane_second_moment(medium, k); }};
  return plane_bodies(like, surface, plane_waves(medium, highest, duration, poll), parities);
}

Body made(const Solid& given, double cutoff, double duration, Direction direction, const Poll& poll) {
  require_solid(given);
  constexpr Range positive{0.0, std::numeric_limits<double>::max(), false, true, "a positive finite number"};
  require("cutoff", cutoff, positive, "highest frequency of the half-space");
  require("duration", duration, positive, "longest contact with the half-space");
  const Medium medium = bodies::half_space::medium(given.contour, given.poisson, direction);
  const double loss_time = given.own_loss_time(), highest = kept_cutoff(cutoff, loss_time);
  const double most = cutoff_of_count(medium, most_waves, duration);
  if (highest > most) {
    throw InvalidInput::out_of_range(
        "cutoff", rounded(cutoff) + " of a half-space for contacts of " + rounded(duration) + " in its own time",
        "a smaller product", "more waves than are computed");
  }
  Body body = unbounded_body(medium, cutoff, loss_time, duration);
  body.name = name_of(given);
  body.scale = {1.0, std::sqrt(given.young / given.density), given.density};
  body.highest_cutoff = loss_time * most > 1.0 ? infinity : most;
  if (given.contour == Contour::cylinder) {
    body.along = [like = body, medium, duration](const Poll& heed) {
      return plane_bodies_of(like, medium, duration, {Parity::normal_even, Parity::along_even}, heed);
    };
  } else if (direction == Direction::normal) {
    body.along = [given, cutoff, duration](const Poll& heed) {
      return std::vector<Body>{made(given, cutoff, duration, Direction::along, heed)};
    };
    body.outward = [like = body, medium, duration](const Poll& heed) {
      return plane_bodies_of(like, medium, duration, {Parity::normal_even}, heed).front();
    };
  }
  set_waves(medium, surface_waves(medium, highest, duration, poll), highest / medium.rayleigh_speed(), body);
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
