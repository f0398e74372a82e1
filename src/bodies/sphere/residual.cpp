#include "bodies/sphere/residual.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace stoss::bodies::sphere {
namespace {

void add(Flexibility& sum, const Mode& mode, double weight) {
  sum.radial += weight * mode.radial * mode.radial;
  sum.mixed += weight * mode.radial * mode.tangential;
  sum.tangential += weight * mode.tangential * mode.tangential;
}

}  // namespace

Residual::Residual(double poisson, double cutoff, const std::vector<Mode>& kept)
    : poisson_(poisson), highest_degree_(static_cast<int>(std::lround(8.0 * cutoff))) {
  const auto degrees = kept.empty() ? 0 : static_cast<std::size_t>(kept.back().order) + 1;
  kept_radial_.resize(degrees);
  kept_.resize(degrees);
  kept_squared_.resize(degrees);
  for (const Mode& mode : kept) {
    const auto n = static_cast<std::size_t>(mode.order);
    const double compliance = 1.0 / (mode.omega * mode.omega);
    kept_radial_[n] += mode.radial * mode.radial;
    add(kept_[n], mode, compliance);
    add(kept_squared_[n], mode, compliance * compliance);
  }
}

std::vector<double> Residual::compliance(const ContactPoints& points, const Poll& poll) const {
  DegreeSum sum{poisson_, true, {}};
  for (const Flexibility& kept : kept_) sum.coefficients.push_back({-kept.radial, -kept.mixed, -kept.tangential});
  return sum_over_degrees(sum, points, poll);
}

std::vector<double> Residual::second_moment(const ContactPoints& points, const Poll& poll) const {
  DegreeSum sum{poisson_, false, {}};
  for (int n = 0; n <= highest_degree_; ++n) {
    sum.coefficients.push_back(static_second_moment(poisson_, n));
    if (static_cast<std::size_t>(n) < kept_squared_.size()) {
      const Flexibility& kept = kept_squared_[static_cast<std::size_t>(n)];
      sum.coefficients.back().radial -= kept.radial;
      sum.coefficients.back().mixed -= kept.mixed;
      sum.coefficients.back().tangential -= kept.tangential;
    }
  }
  return sum_over_degrees(sum, points, poll);
}

double Residual::stable_step() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < kept_.size(); ++n) {
    const double residual = static_flexibility(poisson_, static_cast<int>(n)).radial - kept_[n].radial;
    if (kept_radial_[n] > 0.0) smallest = std::min(smallest, 0.9 * residual / kept_radial_[n]);
  }
  return std::sqrt(smallest);
}

}  // namespace stoss::bodies::sphere
