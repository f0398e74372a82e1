// u_r, σ_rr, σ_φφ = Σ_n (profile of order n) cos nφ;  u_φ, σ_rφ = Σ_n (profile of order n) sin nφ: for each component a
// product of matrices, radii × orders by orders × angles.
#include "stoss/bodies/disk/field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "bodies/disk/order_profiles.hpp"
#include "bodies/disk/radial_field.hpp"
#include "bodies/field_arguments.hpp"
#include "check.hpp"
#include "numeric/dense.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::disk {
namespace {

namespace dense = numeric::dense;

constexpr std::array<bool, OrderProfiles::components> with_cosine{true, false, true, true, false};

template <typename Measure>
std::vector<double> map_stress(const Field& field, Measure measure) {
  std::vector<double> result(field.stress_rr.size());
  require_length("stress_pp", field.stress_pp.size(), result.size(), "as many as of stress_rr");
  require_length("stress_rp", field.stress_rp.size(), result.size(), "as many as of stress_rr");
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = measure(field.stress_rr[i], field.stress_pp[i], field.stress_rp[i]);
  }
  return result;
}

}  // namespace

struct DiskField::Parts {
  OrderProfiles profiles;
  Eigen::ArrayXd angle;
};

DiskField::DiskField(double poisson, const Body& body, const ContactPoints& contact, PolarGrid points,
                     const Poll& poll) {
  require_poisson(poisson);
  validate(body);
  require_nodes(contact, {0.0, 1.0, false, true, "above 0 to 1"}, "of the circle of the points, in R");
  require_points(points, "disk");
  Eigen::ArrayXd angle(static_cast<Eigen::Index>(points.angle.size()));
  // Within one turn, so that multiples of the angle keep their digits.
  std::transform(points.angle.begin(), points.angle.end(), angle.begin(),
                 [](double turned) { return std::remainder(turned, 2.0 * std::numbers::pi); });
  parts_ = std::make_shared<const Parts>(
      Parts{OrderProfiles(poisson, body, contact, std::move(points.radius), poll), std::move(angle)});
}

Field DiskField::at(std::span<const double> coordinate, std::span<const double> node_force, const Poll& poll) const {
  const auto& [profiles, angle] = *parts_;
  const auto modes = profiles.modes(), nodes = profiles.points();
  require_length("coordinate", coordinate.size(), static_cast<std::size_t>(modes), "one for each kept mode");
  require_length("node_force", node_force.size(), static_cast<std::size_t>(nodes), "one for each node");
  require_finite("coordinate", coordinate, "Q of the kept modes, in R");
  require_finite("node_force", node_force, "share of each node in the force, in mc^2/R");
  const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(coordinate.data(), modes);
  const Eigen::ArrayXd force = Eigen::Map<const Eigen::ArrayXd>(node_force.data(), nodes);

  const std::vector<int>& orders = profiles.orders();
  std::array<OrderProfiles::Matrix, OrderProfiles::components> sum;
  for (auto& component : sum) {
    if (poll) poll();
    component.setZero(static_cast<Eigen::Index>(orders.size()), angle.size());
  }
  OrderProfiles::Profile profile;
  const int end = *std::max_element(orders.begin(), orders.end());
  for (int first = 0; first < end; first += order_block) {
    profiles.evaluate(q, force, first, poll, profile);
    // The rows outside this range, usually of small radii, are 0.
    const auto counts = [first](int here) { return here > first; };
    const auto top = std::find_if(orders.begin(), orders.end(), counts);
    const auto bottom = std::find_if(orders.rbegin(), orders.rend(), counts).base();
    const Eigen::Index row = top - orders.begin(), rows = bottom - top;
    const Harmonics at_points = harmonics(angle, first);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const Harmonics::Matrix& harmonic = with_cosine[i] ? at_points.cosine : at_points.sine;
      dense::by_columns(angle.size(), poll, [&](Eigen::Index at, Eigen::Index count) {
        sum[i].block(row, at, rows, count).noalias() +=
            profile[i].middleRows(row, rows) * harmonic.middleCols(at, count);
      });
    }
  }
  const auto flat = [&](std::size_t i) {
    if (poll) poll();
    return std::vector<double>(sum[i].data(), sum[i].data() + sum[i].size());
  };
  return {flat(0), flat(1), flat(2), flat(3), flat(4)};
}

std::vector<double> von_mises(const Field& field) {
  // σ_1² − σ_1σ_2 + σ_2² as a sum of squares.
  return map_stress(field, [](double rr, double pp, double rp) {
    const double sum = rr + pp, difference = rr - pp;
    return std::sqrt(0.25 * sum * sum + 0.75 * difference * difference + 3.0 * rp * rp);
  });
}

std::vector<double> principal_difference(const Field& field) {
  return map_stress(field, [](double rr, double pp, double rp) { return std::hypot(rr - pp, 2.0 * rp); });
}

}  // namespace stoss::bodies::disk
