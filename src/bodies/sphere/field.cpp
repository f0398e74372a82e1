// Each component is a sum over degrees of (profile of the degree) × (a function of θ): products of matrices, radii ×
// degrees by degrees × angles, a block of degrees at a time.
#include "stoss/bodies/sphere/field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "bodies/field_arguments.hpp"
#include "bodies/sphere/degree_profiles.hpp"
#include "bodies/sphere/legendre.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::sphere {
namespace {

using Matrix = DegreeProfiles::Matrix;

/// P, dP/dθ, H = P + cot θ dP/dθ and (L−2)P + H of a block of degrees: degrees × angles.
struct Harmonics {
  Matrix value, slope, across, along;

  explicit Harmonics(Eigen::Index angles)
      : value(DegreeProfiles::block, angles), slope(value), across(value), along(value) {}

  /// Goes on by a block. @param sine, cosine of the angles
  void fill(LegendreSequence& sequence, const Eigen::ArrayXd& sine, const Eigen::ArrayXd& cosine) {
    for (Eigen::Index k = 0; k < value.rows(); ++k, sequence.advance()) {
      const double n = sequence.degree();
      const Eigen::ArrayXd over = sequence.value() - cosine * sequence.slope();
      value.row(k) = sequence.value().matrix().transpose();
      slope.row(k) = (-sine * sequence.slope()).matrix().transpose();
      across.row(k) = over.matrix().transpose();
      along.row(k) = ((n * (n + 1.0) - 2.0) * sequence.value() + over).matrix().transpose();
    }
  }
};

template <typename Measure>
std::vector<double> map_stress(const Field& field, Measure measure) {
  const std::size_t size = field.stress_rr.size();
  for (const std::vector<double>* other : {&field.stress_tt, &field.stress_pp, &field.stress_rt}) {
    require_length("stress", other->size(), size, "as many of each component as of stress_rr");
  }
  std::vector<double> result(size);
  for (std::size_t i = 0; i < size; ++i) {
    result[i] = measure(field.stress_rr[i], field.stress_tt[i], field.stress_pp[i], field.stress_rt[i]);
  }
  return result;
}

}  // namespace

struct SphereField::Parts {
  DegreeProfiles profiles;
  Eigen::ArrayXd angle;  // within half a turn
};

SphereField::SphereField(double poisson, const Body& body, const ContactPoints& contact, PolarGrid points,
                         const Poll& poll) {
  require_poisson(poisson);
  validate(body);
  require_points(points, "sphere");
  require_nodes(contact, {0.0, 1.0, false, true, "above 0 to 1"}, "of the circle of the points, in R");
  Eigen::ArrayXd angle(static_cast<Eigen::Index>(points.angle.size()));
  std::transform(points.angle.begin(), points.angle.end(), angle.begin(),
                 [](double turned) { return std::remainder(turned, 2.0 * std::numbers::pi); });
  parts_ = std::make_shared<const Parts>(
      Parts{DegreeProfiles(poisson, body, contact, std::move(points.radius), poll), std::move(angle)});
}

Field SphereField::at(std::span<const double> coordinate, std::span<const double> node_force, const Poll& poll) const {
  const auto& [profiles, angle] = *parts_;
  const auto modes = profiles.modes(), rings = profiles.points();
  require_length("coordinate", coordinate.size(), static_cast<std::size_t>(modes), "one for each kept mode");
  require_length("node_force", node_force.size(), static_cast<std::size_t>(rings), "one for each ring");
  require_finite("coordinate", coordinate, "Q of the kept modes, in R");
  require_finite("node_force", node_force, "share of each ring in the force, in mc^2/R");
  const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(coordinate.data(), modes);
  const auto loads = profiles.loads(Eigen::Map<const Eigen::ArrayXd>(node_force.data(), rings), poll);

  const std::vector<int>& degrees = profiles.orders();
  std::array<Matrix, 6> sum;  // in the order of Field
  for (Matrix& component : sum) {
    if (poll) poll();
    component.setZero(static_cast<Eigen::Index>(degrees.size()), angle.size());
  }
  auto& [radial, tangential, stress_rr, stress_tt, stress_pp, stress_rt] = sum;
  DegreeProfiles::Profile profile;
  Harmonics harmonics(angle.size());
  LegendreSequence sequence(angle);
  const Eigen::ArrayXd sine = angle.sin(), cosine = angle.cos();
  const int end = *std::max_element(degrees.begin(), degrees.end());
  for (int first = 0; first < end; first += DegreeProfiles::block) {
    profiles.evaluate(q, loads, first, poll, profile);
    harmonics.fill(sequence, sine, cosine);
    // The rows outside this range, usually of small radii, are 0.
    const auto counts = [first](int here) { return here > first; };
    const auto top = std::find_if(degrees.begin(), degrees.end(), counts);
    const auto bottom = std::find_if(degrees.rbegin(), degrees.rend(), counts).base();
    const Eigen::Index row = top - degrees.begin(), rows = bottom - top;
    const auto add = [&](Matrix& to, const Matrix& from, const Matrix& with) {
      if (poll) poll();
      to.middleRows(row, rows).noalias() += from.middleRows(row, rows) * with;
    };
    const auto& [of_radial, of_tangential, of_rr, of_rt, hoop, bend] = profile;
    add(radial, of_radial, harmonics.value);
    add(tangential, of_tangential, harmonics.slope);
    add(stress_rr, of_rr, harmonics.value);
    add(stress_rt, of_rt, harmonics.slope);
    add(stress_pp, hoop, harmonics.value);
    add(stress_pp, bend, harmonics.across);
    add(stress_tt, hoop, harmonics.value);
    add(stress_tt, -bend, harmonics.along);
  }
  const auto flat = [&poll](const Matrix& table) {
    if (poll) poll();
    return std::vector<double>(table.data(), table.data() + table.size());
  };
  return {flat(radial), flat(tangential), flat(stress_rr), flat(stress_tt), flat(stress_pp), flat(stress_rt)};
}

std::vector<double> von_mises(const Field& field) {
  return map_stress(field, [](double rr, double tt, double pp, double rt) {
    const double a = rr - tt, b = tt - pp, c = pp - rr;
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * rt * rt);
  });
}

std::vector<double> principal_difference(const Field& field) {
  return map_stress(field, [](double rr, double tt, double, double rt) { return std::hypot(rr - tt, 2.0 * rt); });
}

}  // namespace stoss::bodies::sphere
