#include "bodies/sphere/residual.hpp"

#include <cmath>

namespace stoss::bodies::sphere {

Residual::Residual(double poisson, double cutoff, const std::vector<Mode>& kept)
    : poisson_(poisson), highest_degree_(static_cast<int>(std::lround(8.0 * cutoff))), kept_(kept) {}

std::vector<double> Residual::compliance(const ContactPoints& points, const Poll& poll) const {
  return sum_over_degrees({poisson_, true, kept_.missing_compliance()}, points, poll);
}

std::vector<double> Residual::second_moment(const ContactPoints& points, const Poll& poll) const {
  const auto whole = [this](int n) { return static_second_moment(poisson_, n); };
  return sum_over_degrees({poisson_, false, kept_.remaining_second_moment(highest_degree_, whole)}, points, poll);
}

double Residual::stable_step() const {
  constexpr double share = 0.9;
  return kept_.stable_step(share, [this](int n) { return static_flexibility(poisson_, n); });
}

}  // namespace stoss::bodies::sphere
