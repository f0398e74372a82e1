// The event-driven gas of examples/gas with particles that rub and turn, of two and three dimensions: what is
// conserved, and the mean-field theory of rough particles (M. Huthmann and A. Zippelius, Phys. Rev. E 56, R6275, 1997).
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "../../examples/gas/gas.hpp"

namespace {

using gas::Outcome;

constexpr std::size_t particles = 1000;

/// ε along the normal and ε_t = −s′/s.
gas::Rule constant(double restitution, double tangential) {
  return [=](double, double sliding, double) { return Outcome{restitution, -tangential * sliding}; };
}

template <typename Dimension>
class RoughGas : public ::testing::Test {
 protected:
  static constexpr std::size_t dimension = Dimension::value;
  static constexpr double turns = dimension == 2 ? 1.0 : 3.0;      // degrees of freedom of the rotation
  static constexpr double inertia = dimension == 2 ? 0.5 : 0.4;    // I/mR²
  static constexpr double packing = dimension == 2 ? 0.05 : 0.03;  // so thin that velocities are hardly correlated
  using Gas = gas::Gas<dimension>;

  static Gas made(std::uint64_t seed) { return Gas(std::vector<double>(particles, 1.0), packing, 1.0, seed); }

  /// Mean energy over half of the degrees of freedom.
  static double of_translation(const Gas& gas) { return gas.translation() / (0.5 * dimension * particles); }
  static double of_rotation(const Gas& gas) { return gas.rotation() / (0.5 * turns * particles); }

  /// Changes of both temperatures in a collision, of one particle: of normal and tangential motion with Gaussian
  /// velocities of any two that meet, with η = q(1 + ε_t)/2(1 + q), q = I/mR².
  static std::pair<double, double> changes(double restitution, double tangential, double moving, double turning) {
    const double eta = inertia * (1.0 + tangential) / (2.0 * (1.0 + inertia));
    const double slides = moving + turning / inertia, ways = 2.0 * (dimension - 1.0);
    const double lost = (1.0 - restitution * restitution) * moving + ways * eta * (moving - eta * slides);
    const double gained = ways * eta / inertia * (eta * slides - turning);
    return {-lost / dimension, gained / turns};
  }
};

template <std::size_t D>
struct Dimensions {
  static constexpr std::size_t value = D;
};
using BothDimensions = ::testing::Types<Dimensions<2>, Dimensions<3>>;
TYPED_TEST_SUITE(RoughGas, BothDimensions);

TYPED_TEST(RoughGas, ThatIsPerfectKeepsEnergyAndSharesItEqually) {
  auto gas = this->made(1);
  const double energy = gas.energy();
  EXPECT_EQ(gas.rotation(), 0.0);
  double ratio = 0.0;
  constexpr int samples = 100;
  for (int k = 0; k < samples; ++k) {
    gas.advance(300.0 + 5.0 * k, constant(1.0, 1.0));
    ratio += this->of_rotation(gas) / this->of_translation(gas) / samples;
  }
  EXPECT_NEAR(gas.energy() / energy, 1.0, 1e-11);
  EXPECT_NEAR(ratio, 1.0, 0.03);
  for (std::size_t k = 0; k < TypeParam::value; ++k) {
    double momentum = 0.0;
    for (const auto& its : gas.particles()) momentum += its.mass * its.velocity[k];
    EXPECT_NEAR(momentum, 0.0, 1e-9);
  }
}

TYPED_TEST(RoughGas, ThatIsSmoothDoesNotTurn) {
  auto gas = this->made(2);
  gas.advance(50.0, constant(0.9, -1.0));
  EXPECT_GT(gas.collisions(), 1000);
  EXPECT_EQ(gas.rotation(), 0.0);
}

TYPED_TEST(RoughGas, CoolsAsMeanFieldTheorySays) {
  constexpr double restitution = 0.95;
  for (const double tangential : {-0.5, 0.3}) {
    auto gas = this->made(3);
    gas.advance(20.0, constant(1.0, -1.0));
    double moving = this->of_translation(gas), turning = 0.0, before = static_cast<double>(gas.collisions());
    const double start = moving;
    for (int k = 1; k <= 60 && moving > 0.05 * start; ++k) {
      gas.advance(gas.time() + 3.0 / std::sqrt(moving), constant(restitution, tangential));
      // As many collisions, in small steps; each is of two particles.
      const double now = static_cast<double>(gas.collisions()), each = 2.0 * (now - before) / particles / 100.0;
      before = now;
      for (int step = 0; step < 100; ++step) {
        const auto [lost, gained] = this->changes(restitution, tangential, moving, turning);
        moving += each * lost;
        turning += each * gained;
      }
      EXPECT_NEAR(this->of_translation(gas) / moving, 1.0, 0.08) << tangential << ' ' << k;
      if (k > 10) {
        EXPECT_NEAR(this->of_rotation(gas) / turning, 1.0, 0.15) << tangential << ' ' << k;
      }
    }
    EXPECT_LT(moving, 0.5 * start);
  }
}

}  // namespace
