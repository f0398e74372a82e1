// The event-driven gas of examples/gas with particles that rub and turn, of two and three dimensions: what is
// conserved, and the mean-field theory of rough particles (M. Huthmann and A. Zippelius, Phys. Rev. E 56, R6275, 1997).
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "../../examples/gas/gas.hpp"
#include "../../examples/gas/mean_field.hpp"

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
  static constexpr double packing = dimension == 2 ? 0.05 : 0.03;  // so thin that velocities are hardly correlated
  using Gas = gas::Gas<dimension>;

  static Gas made(std::uint64_t seed) { return Gas(std::vector<double>(particles, 1.0), packing, 1.0, seed); }
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
    ratio += gas.temperature_of_rotation() / gas.temperature() / samples;
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
  for (const double tangential : {-0.5, 0.3}) {
    const gas::MeanField theory{TypeParam::value, 0.95, tangential};
    auto gas = this->made(3);
    gas.advance(20.0, constant(1.0, -1.0));
    gas::MeanField::State said{gas.temperature(), 0.0};
    const double start = said.moving;
    auto before = gas.collisions();
    for (int k = 1; k <= 60 && said.moving > 0.05 * start; ++k) {
      gas.advance(gas.time() + 3.0 / std::sqrt(said.moving), constant(theory.restitution, tangential));
      said = theory.after(said, 2.0 * static_cast<double>(gas.collisions() - before) / particles);
      before = gas.collisions();
      EXPECT_NEAR(gas.temperature() / said.moving, 1.0, 0.08) << tangential << ' ' << k;
      if (k > 10) {
        EXPECT_NEAR(gas.temperature_of_rotation() / said.turning, 1.0, 0.15) << tangential << ' ' << k;
      }
    }
    EXPECT_LT(said.moving, 0.5 * start);
  }
}

}  // namespace
