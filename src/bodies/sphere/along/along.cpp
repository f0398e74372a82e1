#include "bodies/sphere/along/along.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "bodies/residual.hpp"
#include "bodies/sphere/along/toroidal.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/hole/hole.hpp"
#include "bodies/sphere/hole/radial_shell.hpp"
#include "bodies/sphere/legendre.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "bodies/sphere/surface_points.hpp"

namespace stoss::bodies::sphere {
namespace {

/// @param unit amplitude of a mode of the mass of the body, over that of one of the mass of a solid sphere
std::vector<ModeGroup> groups_along(const std::vector<ModeGroup>& axial, const std::vector<ToroidalMode>& toroidal,
                                    double unit) {
  std::vector<ModeGroup> groups;
  for (ModeGroup group : axial) {
    if (group.order == 0) continue;
    const AlongShare share = along_share(group.order);
    for (double& weight : group.upper) weight *= share.upper;
    for (double& weight : group.lower) weight *= share.lower;
    groups.push_back(std::move(group));
  }
  for (const ToroidalMode& mode : toroidal) {
    const double n = mode.order;
    const auto row = static_cast<std::size_t>(mode.order);
    if (mode.index == 0) {
      groups.push_back({mode.order, {}, {}, {}, row, row, {}, n});
    }
    groups.back().omega.push_back(mode.omega);
    groups.back().upper.push_back(unit * mode.amplitude * std::sqrt(0.5 * n * (n + 1.0)));
    groups.back().lower.push_back(0.0);
  }
  return groups;
}

/// W and V along the surface of the modes that are not kept.
class ResidualAlong {
 public:
  ResidualAlong(double poisson, double cutoff, const Kept& kept, const std::vector<ToroidalMode>& toroidal,
                const Poll& poll)
      : poisson_(poisson),
        excess_(kept.hole.excess(poll)),
        toroidal_excess_(kept.hole.toroidal_excess(poll)),
        highest_degree_(Residual::highest_order(cutoff, excess_)),
        kept_(*kept.modes) {
    for (const ToroidalMode& mode : toroidal) {
      const auto n = static_cast<std::size_t>(mode.order);
      compliance_.resize(n + 1);
      second_moment_.resize(n + 1);
      const double square = mode.amplitude / mode.omega;
      compliance_[n] += square * square;
      second_moment_[n] += square * square / (mode.omega * mode.omega);
    }
  }

  [[nodiscard]] std::vector<double> compliance(const ContactPoints& points, const Poll& poll) const {
    std::vector<double> toroidal = toroidal_excess_.compliance;
    toroidal.resize(std::max(toroidal.size(), compliance_.size()));
    for (std::size_t n = 0; n < compliance_.size(); ++n) toroidal[n] -= compliance_[n];
    return sum_over_degrees({{poisson_, true, kept_.missing_compliance(excess_)}, true, std::move(toroidal)}, points,
                            poll);
  }

  [[nodiscard]] std::vector<double> second_moment(const ContactPoints& points, const Poll& poll) const {
    const auto whole = [this](int n) {
      return static_second_moment(poisson_, n) + OrderExcess::at(excess_.second_moment, n);
    };
    std::vector<double> toroidal{0.0};
    for (int n = 1; n <= highest_degree_; ++n) toroidal.push_back(toroidal_second_moment(poisson_, n));
    for (std::size_t n = 1; n < std::min(toroidal.size(), toroidal_excess_.second_moment.size()); ++n) {
      toroidal[n] += toroidal_excess_.second_moment[n];
    }
    for (std::size_t n = 1; n < std::min(toroidal.size(), second_moment_.size()); ++n) {
      toroidal[n] -= second_moment_[n];
    }
    return sum_over_degrees(
        {{poisson_, false, kept_.remaining_second_moment(highest_degree_, whole)}, true, std::move(toroidal)}, points,
        poll);
  }

 private:
  double poisson_;
  OrderExcess excess_;
  Hole::Toroidal toroidal_excess_;
  int highest_degree_;  // in the second moment
  KeptSums kept_;
  std::vector<double> compliance_, second_moment_;  // of the kept toroidal modes, by degree
};

}  // namespace

Surface surface_along(double poisson, std::size_t rows, const ContactPoints& points) {
  const WaveSpeeds speed = wave_speeds(poisson);
  Surface surface = axial_surface(poisson, rows, points);
  for (std::size_t i = 0; i < points.count; ++i) {
    const double theta = ring_angle(points, i), cosine = std::cos(theta), sine = std::sin(theta);
    const double slowness = sine * sine / speed.pressure + (cosine * cosine + 1.0) / speed.shear;
    surface.impedance[i] = surface.measure[i] / (0.5 * slowness);
  }
  return surface;
}

Body along(const Body& body, double poisson, const Kept& kept, const Poll& poll) {
  const std::vector<ToroidalMode> toroidal = kept.hole.toroidal_modes(poisson, kept_cutoff(body), poll);
  Body twin = body;
  twin.softness = softness_along(poisson);
  twin.stable_step = std::numeric_limits<double>::infinity();  // that of the body is smaller
  twin.groups = groups_along(body.groups, toroidal, std::sqrt(share_of_mass(kept.hole.inner())));
  const auto residual = std::make_shared<const ResidualAlong>(poisson, body.cutoff, kept, toroidal, poll);
  std::size_t rows = 0;
  for (const ModeGroup& group : twin.groups) rows = std::max(rows, group.upper_row + 1);
  twin.surface = [poisson, rows](const ContactPoints& points) { return surface_along(poisson, rows, points); };
  twin.residual_compliance = [residual](const ContactPoints& points, const Poll& heed) {
    return residual->compliance(points, heed);
  };
  twin.residual_second_moment = [residual](const ContactPoints& points, const Poll& heed) {
    return residual->second_moment(points, heed);
  };
  twin.along = nullptr;
  return twin;
}

namespace {

std::size_t row_plus(std::size_t m) { return 2 * m; }
std::size_t row_minus(std::size_t m) { return 2 * m + 1; }

/// @param degrees of the rows, those of 0 only with a minus
Surface surface_outward(double poisson, std::size_t degrees, const ContactPoints& points) {
  const WaveSpeeds speed = wave_speeds(poisson);
  Surface surface = axial_surface(poisson, 0, points);
  for (std::vector<double>* array : {&surface.recess, &surface.measure}) {
    const std::vector<double> rings = *array;
    array->insert(array->end(), rings.begin(), rings.end());
  }
  Eigen::ArrayXd angle(static_cast<Eigen::Index>(points.count));
  for (std::size_t i = 0; i < points.count; ++i) {
    const double theta = ring_angle(points, i), cosine = std::cos(theta), sine = std::sin(theta);
    angle(static_cast<Eigen::Index>(i)) = theta;
    surface.impedance.push_back(surface.measure[i] / (sine * sine / speed.pressure + cosine * cosine / speed.shear));
  }
  const Eigen::ArrayXd sine = angle.sin();
  LegendreSequence sequence(angle);
  for (std::size_t m = 0; m < degrees; ++m, sequence.advance()) {
    const Eigen::ArrayXd associated = sine * sequence.slope();
    const auto degree = static_cast<double>(m);
    for (const double share : {1.0 / std::max(degree, 1.0), -1.0 / (degree + 1.0)}) {
      surface.shape.insert(surface.shape.end(), sequence.value().begin(), sequence.value().end());
      for (const double value : associated) surface.shape.push_back(share * value);
    }
  }
  return surface;
}

std::vector<ModeGroup> groups_outward(std::vector<ModeGroup> groups) {
  for (ModeGroup& group : groups) {
    const auto n = static_cast<std::size_t>(group.order);
    group.upper_row = row_plus(n + 1);
    group.lower_row = n > 0 ? row_minus(n - 1) : row_plus(1);
  }
  return groups;
}

/// W and V of both components.
class ResidualOutward {
 public:
  ResidualOutward(double poisson, double cutoff, const Kept& kept, const Poll& poll)
      : poisson_(poisson),
        excess_(kept.hole.excess(poll)),
        highest_degree_(Residual::highest_order(cutoff, excess_)),
        kept_(*kept.modes) {}

  [[nodiscard]] std::vector<double> compliance(const ContactPoints& points, const Poll& poll) const {
    return sum_over_degrees({{poisson_, true, kept_.missing_compliance(excess_)}, false, {}, true}, points, poll);
  }

  [[nodiscard]] std::vector<double> second_moment(const ContactPoints& points, const Poll& poll) const {
    const auto whole = [this](int n) {
      return static_second_moment(poisson_, n) + OrderExcess::at(excess_.second_moment, n);
    };
    return sum_over_degrees({{poisson_, false, kept_.remaining_second_moment(highest_degree_, whole)}, false, {}, true},
                            points, poll);
  }

 private:
  double poisson_;
  OrderExcess excess_;
  int highest_degree_;  // in the second moment
  KeptSums kept_;
};

}  // namespace

Body outward(const Body& body, double poisson, const Kept& kept, const Poll& poll) {
  Body twin = body;
  twin.components = 2;
  twin.groups = groups_outward(body.groups);
  const std::size_t degrees = kept.modes->empty() ? 0 : static_cast<std::size_t>(kept.modes->back().order) + 2;
  twin.surface = [poisson, degrees](const ContactPoints& points) { return surface_outward(poisson, degrees, points); };
  const auto residual = std::make_shared<const ResidualOutward>(poisson, body.cutoff, kept, poll);
  twin.residual_compliance = [residual](const ContactPoints& points, const Poll& heed) {
    return residual->compliance(points, heed);
  };
  twin.residual_second_moment = [residual](const ContactPoints& points, const Poll& heed) {
    return residual->second_moment(points, heed);
  };
  twin.along = nullptr;
  twin.outward = nullptr;
  return twin;
}

}  // namespace stoss::bodies::sphere
