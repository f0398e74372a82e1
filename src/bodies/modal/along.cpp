#include "bodies/modal/along.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "bodies/half_space/surface_waves.hpp"
#include "bodies/modal/point_modes.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "bodies/surface/residual.hpp"
#include "check.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::modal {
namespace {

/// Duration for which the quadrature of the half-space that gives V is made, own_length/c.
constexpr double local_duration = 6.0;

/// Up to which a mode, or turning, may move the point in both directions, over what a rigid body moves it.
constexpr double most_shared = 0.05;

/// 1/√(m m_t) of a rigid body, by which the products of both directions are measured.
double rigid_mobility(const ModalBody& its) {
  const PointTangent& tangent = *its.tangent;
  const double turning = tangent.inertia > 0.0 ? tangent.arm * tangent.arm / tangent.inertia : 0.0;
  return std::sqrt((1.0 / tangent.mass + turning) / its.mass);
}

/// Whether the errors of its frequency and of that of the next mode overlap: both may be combinations of two others.
bool is_one_with_next(const ModalBody& its, std::size_t i) {
  if (i + 1 == its.modes.size()) return false;
  const PointMode &one = its.modes[i], &next = its.modes[i + 1];
  return next.omega - next.omega_error <= one.omega + one.omega_error;
}

/// As if the surface were softer by a share, and its logarithm that of another curvature.
void make_uneven(double poisson, const Unevenness& uneven, const ContactPoints& points, std::vector<double>& matrix) {
  const double slow = sphere::softness_along(poisson) / std::numbers::pi * logarithm_share_along(poisson);
  for (std::size_t i = 0; i < points.count; ++i) {
    for (std::size_t j = 0; j < points.count; ++j) {
      double& each = matrix[i * points.count + j];
      each *= 1.0 + uneven.softness;
      each -= slow * uneven.curvature * std::log(lateral_distance(points, std::max(i, j)));
    }
  }
}

/// What all twins have from the body, and none of what they do not ask.
Body twin_of(const Body& body) {
  Body twin = body;
  twin.along = nullptr;
  twin.outward = nullptr;
  twin.known.alternatives = nullptr;
  twin.known.alternatives_along = nullptr;
  return twin;
}

}  // namespace

// The share of all up to any mode counts: of modes close to each other one takes back what the other does.
void require_apart(const ModalBody& its) {
  if (!its.tangent) {
    throw InvalidInput::out_of_range("friction", "'" + its.name + "' without tangential data",
                                     "a body with them: its tangent, and the tangential displacement of its modes",
                                     "or leave friction out, or take 0");
  }
  const double unit = rigid_mobility(its);
  double sum = its.tangent->cross;
  const auto require_share = [&](const std::string& what) {
    const double share = std::abs(sum) / unit;
    if (share <= most_shared) return;
    throw InvalidInput::out_of_range(
        "friction",
        "'" + its.name + "' whose " + what +
            " moves the point along the normal and along the surface at once, by a share of " +
            shown(std::round(1000.0 * share) / 1000.0),
        "up to " + shown(most_shared), "take a point, or a direction, of its symmetry");
  };
  require_share("turning");
  for (std::size_t i = 0; i < its.modes.size() && its.modes[i].omega <= its.complete_to; ++i) {
    sum += its.modes[i].displacement * its.modes[i].tangential;
    if (!is_one_with_next(its, i)) require_share("mode " + std::to_string(i + 1));
  }
}

Body along(const Body& body, const ModalBody& its, const PointModes& modes, const Unevenness& uneven) {
  const PointSurroundings near{its.poisson, its.curvature == 0.0};
  Body twin = twin_of(body);
  twin.softness = sphere::softness_along(its.poisson);
  twin.groups = groups_of(modes, Direction::along);
  twin.surface = [near](const ContactPoints& points) { return point_surface(near, Direction::along, points); };
  twin.residual_compliance = [near, modes, uneven](const ContactPoints& points, const Poll& poll) {
    std::vector<double> compliance = local_compliance(near, Direction::along, points, poll);
    if (uneven.curvature > 0.0) make_uneven(near.poisson, uneven, points, compliance);
    for (double& each : compliance) each += modes.constant_along;
    take_kept(modes, Direction::along, points, points.count, compliance);
    return compliance;
  };
  twin.residual_second_moment = [poisson = its.poisson, cutoff = body.cutoff](const ContactPoints& points,
                                                                              const Poll& poll) {
    const Body surroundings = stoss::half_space(HalfSpace{poisson}, cutoff, local_duration, poll);
    return surroundings.along(poll).front().residual_second_moment(points, poll);
  };
  return twin;
}

Body outward(const Body& body, const ModalBody& its, const PointModes& modes) {
  const PointSurroundings near{its.poisson, its.curvature == 0.0};
  // Without waves, which the modes of the body stand for.
  constexpr double no_waves = 1e-6;
  const auto without_waves = [near](const Poll& poll) {
    if (near.plane) return stoss::half_space(HalfSpace{near.poisson}, no_waves, local_duration, poll).outward(poll);
    return stoss::sphere(Sphere{near.poisson}, no_waves, poll).outward(poll);
  };
  Body twin = twin_of(body);
  twin.components = 2;
  twin.surface = [near, without_waves](const ContactPoints& points) {
    Surface surface = without_waves({}).surface(points);
    const std::vector<double> rows = point_surface(near, Direction::normal, points).shape;
    surface.shape.clear();
    for (std::size_t row = 0; row < 2; ++row) {  // 1 and r² along the normal, nothing along the surface
      const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(row * points.count);
      surface.shape.insert(surface.shape.end(), begin, begin + static_cast<std::ptrdiff_t>(points.count));
      surface.shape.resize(surface.shape.size() + points.count);
    }
    return surface;
  };
  twin.residual_compliance = [near, without_waves, modes](const ContactPoints& points, const Poll& poll) {
    std::vector<double> compliance = without_waves(poll).residual_compliance(points, poll);
    const double constant = modes.constant - (near.plane ? 0.0 : sphere_constant(near.poisson));
    for (std::size_t i = 0; i < points.count; ++i) {
      for (std::size_t j = 0; j < points.count; ++j) compliance[i * 2 * points.count + j] += constant;
    }
    take_kept(modes, Direction::normal, points, 2 * points.count, compliance);
    return compliance;
  };
  twin.residual_second_moment = [poisson = its.poisson, cutoff = body.cutoff](const ContactPoints& points,
                                                                              const Poll& poll) {
    const Body surroundings = stoss::half_space(HalfSpace{poisson}, cutoff, local_duration, poll);
    return surroundings.outward(poll).residual_second_moment(points, poll);
  };
  return twin;
}

std::function<double(double)> cross_mobility(const ModalBody& its, const PointModes& modes) {
  if (!its.tangent) return {};
  const double length = own_length(its), unit = its.density * length * length * length;  // of mass
  return [rigid = its.tangent->cross * unit, modes](double duration) {
    // An impulse like half a sine excites cos(ωT/2)/(1 − (ωT/π)²) of a mode, which this falling function bounds: so
    // the sum over all modes is at most that of its fall times the sums of their products so far (Abel).
    const auto excited = [duration](double omega) {
      const double turns = omega * duration / std::numbers::pi;
      return 1.0 / (1.0 + (std::numbers::pi * std::numbers::pi / 8.0 - 1.0) * turns * turns);
    };
    double product = rigid, last = 1.0, bound = 0.0;
    for (const KeptMode& mode : modes.kept) {
      const double here = excited(mode.omega);
      bound += (last - here) * std::abs(product);
      product += mode.displacement * mode.tangential / modes.mass;
      last = here;
    }
    return bound + last * std::abs(product);
  };
}

}  // namespace stoss::bodies::modal
