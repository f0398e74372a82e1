// A mode of a material that relaxes, as a sum of decays, against the exponential of its whole matrix.
#include "relaxation/oscillator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include "numeric/damped_oscillator.hpp"

namespace stoss {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// (Q, Q̇, q_j)′ of Maxwell branches.
MatrixXd matrix(double omega, const Rates& rates) {
  const auto terms = static_cast<Eigen::Index>(rates.rate.size());
  MatrixXd a = MatrixXd::Zero(terms + 2, terms + 2);
  a(0, 1) = 1.0;
  a(1, 0) = -omega * omega * rates.relaxed;
  for (Eigen::Index j = 0; j < terms; ++j) {
    const auto k = static_cast<std::size_t>(j);
    a(1, 0) -= omega * omega * rates.share[k];
    a(1, 2 + j) = omega * omega * rates.share[k];
    a(2 + j, 0) = rates.rate[k];
    a(2 + j, 2 + j) = -rates.rate[k];
  }
  return a;
}

struct Motion {
  double place, speed;
  std::vector<double> decaying;

  [[nodiscard]] double displacement() const {
    double sum = place;
    for (const double each : decaying) sum += each;
    return sum;
  }
};

Motion after(const LossyOscillator& mode, double time) {
  const auto [position, coupling, velocity] = numeric::damped_motion(mode.frequency, mode.gamma, time);
  const double jump = mode.velocity / mode.frequency;
  Motion motion{
      position * mode.place + coupling * jump, mode.frequency * (velocity * jump - coupling * mode.place), {}};
  for (std::size_t k = 0; k < mode.rate.size(); ++k) {
    motion.decaying.push_back(mode.residue[k] * std::exp(-mode.rate[k] * time));
  }
  return motion;
}

VectorXd kicked(const Rates& rates) {
  VectorXd state = VectorXd::Zero(static_cast<Eigen::Index>(rates.rate.size()) + 2);
  state(1) = 1.0;
  return state;
}

void expect_exact(double omega, const Relaxation& relaxation, double time) {
  const Rates rates(relaxation);
  const LossyOscillator mode = relaxing_oscillator(omega, rates);
  const Motion motion = after(mode, time);
  const VectorXd exact = (matrix(omega, rates) * time).exp() * kicked(rates);
  EXPECT_NEAR(motion.displacement() * omega, exact(0) * omega, 1e-7) << omega;
  double energy = exact(1) * exact(1) + omega * omega * rates.relaxed * exact(0) * exact(0);
  for (std::size_t j = 0; j < rates.rate.size(); ++j) {
    const double apart = omega * (exact(0) - exact(2 + static_cast<Eigen::Index>(j)));
    energy += rates.share[j] * apart * apart;
  }
  EXPECT_NEAR(mode.energy(motion.place, motion.speed, motion.decaying, 0.0), 0.5 * energy, 1e-7) << omega;
}

/// Up to eight terms over ten decades of times, some very weak, and a mode.
struct Drawn {
  Relaxation relaxation;
  double omega;
};

Drawn drawn(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Drawn result;
  result.omega = std::pow(10.0, -2.0 + 4.0 * uniform(random));
  double left = 1.0;
  for (int terms = 1 + static_cast<int>(8.0 * uniform(random)); terms > 0; --terms) {
    const double share = left * uniform(random) * (uniform(random) < 0.2 ? 1e-6 : 0.8);
    left -= share;
    result.relaxation.terms.push_back({share, std::pow(10.0, -5.0 + 10.0 * uniform(random))});
  }
  return result;
}

}  // namespace

TEST(LossyOscillator, MovesAsTheExponentialOfItsMatrix) {
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    const auto [relaxation, omega] = drawn(random);
    expect_exact(omega, relaxation, (0.2 + 0.01 * i) / omega);
  }
}

// A term of 8/9 with ωτ = 1/√27·… has three equal real zeros; around it two of them nearly coincide.
TEST(LossyOscillator, HasNoSingularityWhereZerosCoincide) {
  for (const double share : {0.85, 8.0 / 9.0, 0.8889, 0.9, 0.95}) {
    for (int i = 0; i <= 400; ++i) expect_exact(1.0, {{{share, 0.05 * std::pow(100.0, i / 400.0)}}}, 3.0);
  }
}

TEST(LossyOscillator, TakesTermsOfOneTimeAsOne) {
  for (const double apart : {0.0, 1e-12, 1e-8, 1e-4}) {
    expect_exact(2.0, {{{0.3, 1.0}, {0.2, 1.0 + apart}, {0.1, 1.0 + 2.0 * apart}}}, 1.0);
  }
}

// What a steady force in kicks leaves out, and the velocity before them, by the sum over all kicks before.
TEST(LossyOscillator, AnswersKicksAsTheirSum) {
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    const auto [relaxation, omega] = drawn(random);
    const Rates rates(relaxation);
    const LossyOscillator mode = relaxing_oscillator(omega, rates);
    const double step = 0.5 / omega;
    const MatrixXd free = (matrix(omega, rates) * step).exp(), one = MatrixXd::Identity(free.rows(), free.cols());
    const VectorXd steady = free * (one - free).partialPivLu().solve(kicked(rates));
    const VectorXd held = -matrix(omega, rates).partialPivLu().solve(kicked(rates));
    const double scale = omega * omega * rates.relaxed;
    EXPECT_NEAR(mode.missing_beside_kicks(step) * scale, (held(0) - step * steady(0)) * scale, 1e-5) << omega;
    EXPECT_NEAR(mode.share_due(step), -steady(1), 1e-6) << omega;
  }
}

TEST(LossyOscillator, OfKelvinAndVoigtIsAPairAlone) {
  const LossyOscillator mode = kelvin_voigt_oscillator(3.0, 0.1);
  EXPECT_TRUE(mode.rate.empty());
  EXPECT_DOUBLE_EQ(mode.gamma, 0.45);
  EXPECT_NEAR(mode.share_due(0.1), numeric::share_due(3.0, 0.45, 0.1), 1e-12);
  EXPECT_NEAR(mode.missing_beside_kicks(0.1), numeric::share_beside_kicks(3.0, 0.45, 0.1) / 9.0, 1e-13);
  // A term that relaxes within a step is one of η = E_j τ_j, on the modulus E∞.
  const LossyOscillator fast = relaxing_oscillator(3.0, Rates({{{0.5, 1e-4}}}));
  EXPECT_NEAR(fast.frequency, 3.0 * std::sqrt(0.5), 1e-4);
  EXPECT_NEAR(fast.gamma, 0.5 * 0.5e-4 * 9.0, 1e-7);
}

}  // namespace stoss
