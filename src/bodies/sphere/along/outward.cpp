#include "bodies/sphere/along/outward.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/legendre.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "bodies/sphere/surface_points.hpp"

namespace stoss::bodies::sphere {
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
  ResidualOutward(double poisson, double cutoff, const std::vector<Mode>& kept)
      : poisson_(poisson), highest_degree_(static_cast<int>(std::lround(8.0 * cutoff))), kept_(kept) {}

  [[nodiscard]] std::vector<double> compliance(const ContactPoints& points, const Poll& poll) const {
    return sum_over_degrees({{poisson_, true, kept_.missing_compliance()}, false, {}, true}, points, poll);
  }

  [[nodiscard]] std::vector<double> second_moment(const ContactPoints& points, const Poll& poll) const {
    const auto whole = [this](int n) { return static_second_moment(poisson_, n); };
    return sum_over_degrees({{poisson_, false, kept_.remaining_second_moment(highest_degree_, whole)}, false, {}, true},
                            points, poll);
  }

 private:
  double poisson_;
  int highest_degree_;  // in the second moment
  KeptSums kept_;
};

}  // namespace

Body outward(const Body& body, double poisson, const std::vector<Mode>& modes) {
  Body twin = body;
  twin.components = 2;
  twin.groups = groups_outward(body.groups);
  const std::size_t degrees = modes.empty() ? 0 : static_cast<std::size_t>(modes.back().order) + 2;
  twin.surface = [poisson, degrees](const ContactPoints& points) { return surface_outward(poisson, degrees, points); };
  const auto residual = std::make_shared<const ResidualOutward>(poisson, body.cutoff, modes);
  twin.residual_compliance = [residual](const ContactPoints& points, const Poll& poll) {
    return residual->compliance(points, poll);
  };
  twin.residual_second_moment = [residual](const ContactPoints& points, const Poll& poll) {
    return residual->second_moment(points, poll);
  };
  twin.along = nullptr;
  twin.outward = nullptr;
  return twin;
}

}  // namespace stoss::bodies::sphere
