// A lossy rod at a hard wall against finite differences for ü = u″ + η u̇″ on 0 < s < 1, with u = 0 at the struck end
// while that is pushed, and free ends otherwise.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "stoss/bodies/rod.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss {
namespace {

/// ε of the rod, with cells of equal size and their masses at their ends; implicit midpoint steps, after a few of
/// backward Euler that smooth the jump of the velocity at the wall.
double difference_restitution(double loss_time, int cells, double step) {
  const auto n = static_cast<std::size_t>(cells);
  const double h = 1.0 / cells;
  std::vector<double> u(n + 1), v(n + 1, 1.0), diagonal(n + 1), right(n + 1), mass(n + 1, h);
  mass.front() = mass.back() = 0.5 * h;
  v.front() = 0.0;
  const auto spring = [&](const std::vector<double>& x, std::size_t i) {  // K x
    double force = 0.0;
    if (i > 0) force += (x[i] - x[i - 1]) / h;
    if (i < n) force += (x[i] - x[i + 1]) / h;
    return force;
  };
  constexpr int smoothing = 8;
  for (int count = 0; count < 10'000'000; ++count) {
    const double now = count < smoothing ? 1.0 : 0.5;  // weight of the end of the step
    const double stiff = now * step * loss_time + now * now * step * step;
    for (std::size_t i = 1; i <= n; ++i) {
      right[i] = mass[i] * v[i] - step * spring(u, i) -
                 ((1.0 - now) * step * loss_time + now * (1.0 - now) * step * step) * spring(v, i);
      diagonal[i] = mass[i] + stiff * (i < n ? 2.0 : 1.0) / h;
    }
    for (std::size_t i = 2; i <= n; ++i) {  // v₀ = 0
      const double factor = -stiff / h / diagonal[i - 1];
      diagonal[i] -= factor * (-stiff / h);
      right[i] -= factor * right[i - 1];
    }
    std::vector<double> after(n + 1);
    for (std::size_t i = n; i >= 1; --i) {
      after[i] = (right[i] + (i < n ? stiff / h * after[i + 1] : 0.0)) / diagonal[i];
    }
    for (std::size_t i = 1; i <= n; ++i) u[i] += step * (now * after[i] + (1.0 - now) * v[i]);
    v = after;
    if (count > smoothing && u[1] + loss_time * v[1] < 0.0) break;  // it would pull
  }
  double momentum = 0.0;
  for (std::size_t i = 0; i <= n; ++i) momentum += mass[i] * v[i];
  return -momentum;
}

class LossyRod : public ::testing::TestWithParam<double> {};

TEST_P(LossyRod, AgreesWithFiniteDifferences) {
  const double eta = GetParam();
  const double coarse = difference_restitution(eta, 400, 5e-4), fine = difference_restitution(eta, 800, 2.5e-4);
  const double exact = fine + (fine - coarse) / 3.0;
  EXPECT_NEAR(fine, exact, 1e-4);
  double before = 1.0;
  for (const double cutoff : {80.0, 320.0, 1280.0}) {
    const Impact result = impact(contact(rod(Rod{.loss_time = eta}, cutoff)), 0.1);
    const double error = std::abs(result.restitution - exact);
    EXPECT_LT(error, 0.6 * before) << cutoff;
    EXPECT_NEAR(result.energy_error, 0.0, 1e-3);
    before = error;
  }
  EXPECT_LT(before, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(LossTimes, LossyRod, ::testing::Values(0.02, 0.1, 0.5, 2.0));

}  // namespace
}  // namespace stoss
