// Terms from moduli: those of one series come back, least squares never goes below 0, and times shift.
#include "stoss/relaxation/measurement.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>

#include "relaxation/nonnegative.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

Moduli moduli_of(const Relaxation& relaxation, double lowest, double highest, int count) {
  Moduli all;
  for (int i = 0; i < count; ++i) {
    all.frequency.push_back(lowest * std::pow(highest / lowest, i / (count - 1.0)));
    const std::complex<double> its = 3e6 * modulus(relaxation, {0.0, all.frequency.back()});
    all.storage.push_back(its.real()), all.loss.push_back(its.imag());
  }
  return all;
}

TEST(MeasuredModuli, GiveBackTheTermsOnTheirTimes) {
  // Three times a decade from 1/1000 to 1, of which these are two.
  const Relaxation its{{{0.3, 1e-2}, {0.5, 0.1}}};
  const FittedRelaxation found = relaxation_of_measurement(moduli_of(its, 1.0, 1e3, 31));
  EXPECT_LT(found.storage_misfit, 1e-9);
  EXPECT_LT(found.loss_misfit, 1e-9);
  EXPECT_NEAR(found.instantaneous, 3e6, 1.0);
  EXPECT_NEAR(found.relaxation.relaxed(), 0.2, 1e-6);
}

TEST(MeasuredModuli, AreFollowedByTermsBetweenTheirTimes) {
  const Relaxation its{{{0.3, 0.014}, {0.4, 0.23}}};
  const Moduli measured = moduli_of(its, 0.1, 1e4, 41);
  const FittedRelaxation found = relaxation_of_measurement(measured);
  EXPECT_LT(found.storage_misfit, 0.01);
  EXPECT_LT(found.loss_misfit, 0.03);
  for (std::size_t i = 0; i < measured.frequency.size(); ++i) {
    const std::complex<double> fitted = found.instantaneous * modulus(found.relaxation, {0.0, measured.frequency[i]});
    EXPECT_NEAR(fitted.real() / measured.storage[i], 1.0, 0.05);
  }
  EXPECT_NO_THROW(validate(found.relaxation));
}

TEST(MeasuredModuli, AreRefused) {
  const Relaxation its{{{0.3, 0.014}}};
  Moduli falling = moduli_of(its, 1.0, 1e3, 5);
  std::swap(falling.frequency[1], falling.frequency[2]);
  test::expect_refusal([&] { (void)relaxation_of_measurement(falling); }, {"frequency", "rising"});
  Moduli negative = moduli_of(its, 1.0, 1e3, 5);
  negative.loss[3] = -1.0;
  test::expect_refusal([&] { (void)relaxation_of_measurement(negative); }, {"loss", "got -1"});
  test::expect_refusal([&] { (void)relaxation_of_measurement(moduli_of(its, 1.0, 1e3, 2)); },
                       {"frequency", "3 or more"});
}

TEST(ShiftedRelaxation, FollowsWilliamsLandelAndFerry) {
  const Relaxation its{{{0.3, 0.01}, {0.4, 2.0}}};
  EXPECT_EQ(shifted(its, 17.4, 51.6, 20.0, 20.0), its);
  const Relaxation warm = shifted(its, 17.4, 51.6, 20.0, 50.0);
  const double factor = std::pow(10.0, -17.4 * 30.0 / 81.6);
  EXPECT_NEAR(warm.terms[1].time / (2.0 * factor), 1.0, 1e-12);
  EXPECT_EQ(warm.terms[1].share, 0.4);
  test::expect_refusal([&] { (void)shifted(its, 17.4, 51.6, 20.0, -31.6); }, {"temperature", "above -31.6"});
}

TEST(NonnegativeLeastSquares, LeavesOutWhatWouldBeNegative) {
  Eigen::MatrixXd matrix(3, 2);
  matrix << 1, 0, 0, 1, 1, 1;
  // Without the bound x = (2, −1); with it (1.5, 0).
  const Eigen::VectorXd found = nonnegative_least_squares(matrix, Eigen::Vector3d(2, -1, 1));
  EXPECT_NEAR(found(0), 1.5, 1e-12);
  EXPECT_EQ(found(1), 0.0);
  const Eigen::VectorXd both = nonnegative_least_squares(matrix, Eigen::Vector3d(2, 1, 3));
  EXPECT_NEAR(both(0), 2.0, 1e-12);
  EXPECT_NEAR(both(1), 1.0, 1e-12);
}

}  // namespace
}  // namespace stoss
