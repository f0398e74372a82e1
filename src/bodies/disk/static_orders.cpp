#include <cmath>

#include "bodies/disk/order_sums.hpp"

namespace stoss::bodies::disk {

StaticOrders::StaticOrders(double poisson)
    : zero_(static_flexibility(poisson, 0)),
      one_(static_flexibility(poisson, 1)),
      low_(0.5 * (1.0 + poisson)),
      high_(0.5 * (3.0 - poisson)) {}

StaticSums StaticOrders::at(double theta, double cosine_sum, double sine_sum, double last, double highest) const {
  const double cosine = std::cos(theta), sine = std::sin(theta);
  const double c = cosine_sum, s = sine_sum;
  // Σ cos nθ/(n−1), Σ cos nθ/(n+1) and the same with sin nθ, from n = 2 to N: shifted by one order. sin Nθ = 0.
  const double up_cosine = cosine * c - sine * s - last * (1.0 / (highest - 1.0) + cosine / highest);
  const double down_cosine =
      cosine * c + sine * s - 1.0 - 0.5 * cosine + last * (cosine / highest + 1.0 / (highest + 1.0));
  const double up_sine = sine * c + cosine * s - last * sine / highest;
  const double down_sine = cosine * s - sine * c - 0.5 * sine - last * sine / highest;
  return {zero_.radial + one_.radial * cosine + low_ * up_cosine + high_ * down_cosine,
          one_.mixed * sine - low_ * up_sine + high_ * down_sine,
          zero_.tangential + one_.tangential * cosine + low_ * up_cosine + high_ * down_cosine};
}

}  // namespace stoss::bodies::disk
