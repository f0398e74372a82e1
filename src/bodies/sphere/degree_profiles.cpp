#include "bodies/sphere/degree_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/sphere/legendre.hpp"
#include "bodies/sphere/radial_field.hpp"

namespace stoss::bodies::sphere {
namespace {

RadialPowers powers(double radius, int degree) {
  const double ring = (1.0 - radius) * (1.0 + radius);  // r^{n−2} − r^n = r^{n−2}(1 − r²)
  const double lowest = degree >= 2 ? std::pow(radius, degree - 2) : 0.0;
  const double low = degree >= 2 ? lowest * radius : (degree == 1 ? 1.0 : 0.0);
  const double here = degree >= 1 ? low * radius : 1.0;
  return {lowest * ring, low, here, here * radius};
}

}  // namespace

DegreeProfiles::DegreeProfiles(double poisson, const Body& body, const ContactPoints& contact,
                               std::vector<double> radius, const Poll& poll)
    : KeptProfiles(poisson, body, contact, std::move(radius), poll) {}

DegreeProfiles::Loads DegreeProfiles::loads(const Eigen::ArrayXd& ring_force, const Poll& poll) const {
  const int end = *std::max_element(orders().begin(), orders().end());
  const Eigen::ArrayXd along = ring_force * point_.cos(), across = ring_force * point_.sin().square();
  LegendreSequence sequence(point_);
  Loads loads;
  for (int n = 0; n < end; ++n, sequence.advance()) {
    if (poll && n % 64 == 0) poll();
    loads.radial.push_back(-weight(n) * (along * sequence.value()).sum());
    loads.tangential.push_back(-weight(n) * (across * sequence.slope()).sum());
  }
  return loads;
}

void DegreeProfiles::add_static(const Loads& loads, int first, const Poll& poll, Profile& profile) const {
  for (int k = 0; k < block && first + k < static_cast<int>(loads.radial.size()); ++k) {
    if (poll) poll();
    const int n = first + k;
    const auto at = static_cast<std::size_t>(n);
    const double unit = (2.0 * n + 1.0) / 3.0;
    const double shear = n > 0 ? unit * loads.tangential[at] / (n * (n + 1.0)) : 0.0;
    const StaticField field = static_field(poisson_, n, unit * loads.radial[at], shear);
    for (std::size_t r = 0; r < radius_.size(); ++r) {
      if (orders()[r] <= n) continue;
      const auto value = ProfileShape::values(field.at(powers(radius_[r], n)));
      for (std::size_t i = 0; i < components; ++i) profile[i](static_cast<Eigen::Index>(r), k) += value[i];
    }
  }
}

void DegreeProfiles::evaluate(const Eigen::VectorXd& coordinate, const Loads& loads, int first, const Poll& poll,
                              Profile& profile) const {
  for (Matrix& component : profile) component.setZero(static_cast<Eigen::Index>(radius_.size()), block);
  add_static(loads, first, poll, profile);
  const auto load = [&](int degree) {
    const auto n = static_cast<std::size_t>(degree);
    return std::array{loads.radial[n], loads.tangential[n]};
  };
  add_kept(coordinate, load, first, block, profile);
}

}  // namespace stoss::bodies::sphere
