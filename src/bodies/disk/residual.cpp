#include "bodies/disk/residual.hpp"

#include <cmath>

namespace stoss::bodies::disk {
namespace {

std::vector<double> sum_over_orders(const OrderSum& sum, const ContactPoints& points, const Poll& poll) {
  if (points.count == 0) return {};
  return points.radius == 1.0 ? sum_at_equal_angles(sum, points, poll) : sum_at_mapped_angles(sum, points, poll);
}

}  // namespace

Residual::Residual(double poisson, double cutoff, const std::vector<Mode>& kept)
    : poisson_(poisson), highest_order_(static_cast<int>(std::lround(8.0 * cutoff))), kept_(kept) {}

std::vector<double> Residual::compliance(const ContactPoints& points, const Poll& poll) const {
  return sum_over_orders({poisson_, true, kept_.missing_compliance()}, points, poll);
}

std::vector<double> Residual::second_moment(const ContactPoints& points, const Poll& poll) const {
  const auto whole = [this](int n) { return static_second_moment(poisson_, n); };
  return sum_over_orders({poisson_, false, kept_.remaining_second_moment(highest_order_, whole)}, points, poll);
}

double Residual::stable_step() const {
  constexpr double share = 1.8;
  return kept_.stable_step(share, [this](int n) { return static_flexibility(poisson_, n); });
}

}  // namespace stoss::bodies::disk
