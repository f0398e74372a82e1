// Force against compression: the laws, their inverse, their energy and what they are for small loads.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "stoss/quasistatic/compression.hpp"
#include "support/printed_law.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

constexpr std::array laws{CompressionLaw::center, CompressionLaw::diameter};
constexpr std::array poissons{-0.95, -0.3, 0.0, 0.33, 0.9, 0.995};

/// The laws as they are written (docs/theory/errata.md, E7 and E8).
double written(CompressionLaw law, double poisson, double force) {
  if (law == CompressionLaw::center) return force * (std::log(1.0 / force) - 0.25 * (1.0 + poisson));
  return force * (std::log(4.0 / force) - 1.0);
}

TEST(QuasistaticCompression, IsWhatTheLawsSay) {
  for (const auto law : laws) {
    for (const double poisson : poissons) {
      for (double force = 1e-300; force < 0.05; force *= 7.0) {
        const double expected = written(law, poisson, force);
        EXPECT_NEAR(compression(law, poisson, force), expected, 4e-15 * expected) << force;
      }
    }
  }
}

TEST(QuasistaticCompression, HasItsMaximumAtTheLimitForce) {
  for (const auto law : laws) {
    for (const double poisson : poissons) {
      const double limit = limit_force(law, poisson);
      EXPECT_DOUBLE_EQ(compression(law, poisson, limit), limit);
      EXPECT_NEAR(written(law, poisson, limit), limit, 1e-15);
      for (const double factor : {0.99, 0.999, 1.001, 1.01}) EXPECT_LT(written(law, poisson, factor * limit), limit);
    }
  }
}

TEST(QuasistaticCompression, InverseComesBack) {
  for (const auto law : laws) {
    for (const double poisson : poissons) {
      const double limit = limit_force(law, poisson);
      for (double share = 1e-305; share < 0.9; share *= 3.0) {
        const double force = share * limit;
        // dF/F per dδ/δ is u/(u − 1): rounding of δ alone makes this much.
        const double u = 1.0 - std::log(share);
        EXPECT_NEAR(compression_force(law, poisson, compression(law, poisson, force)), force,
                    1e-15 * std::max(4.0, u / (u - 1.0)) * force)
            << share;
      }
      for (const double short_of : {0.0, 1e-15, 1e-12, 1e-6, 1e-2}) {
        const double delta = limit * (1.0 - short_of);
        EXPECT_NEAR(compression(law, poisson, compression_force(law, poisson, delta)), delta, 1e-15 * limit)
            << short_of;
      }
      EXPECT_EQ(compression_force(law, poisson, 0.0), 0.0);
    }
  }
}

TEST(QuasistaticCompression, EnergyIsTheWorkOfTheForce) {
  boost::math::quadrature::tanh_sinh<double> integrate;
  for (const auto law : laws) {
    for (const double poisson : poissons) {
      for (const double share : {1e-9, 1e-3, 0.2, 1.0}) {
        const double force = share * limit_force(law, poisson);
        const double work = integrate.integrate([&](double delta) { return compression_force(law, poisson, delta); },
                                                0.0, compression(law, poisson, force));
        EXPECT_NEAR(compression_energy(law, poisson, force), work, 1e-9 * work);
        const double s = law == CompressionLaw::center ? 1.0 : 4.0;
        const double b = law == CompressionLaw::center ? 0.25 * (1.0 + poisson) : 1.0;
        EXPECT_NEAR(compression_energy(law, poisson, force),
                    force * force * (0.5 * std::log(s / force) - 0.5 * b - 0.25), 1e-14 * work);
      }
    }
  }
  EXPECT_EQ(compression_energy(CompressionLaw::center, 0.0, 0.0), 0.0);
}

TEST(QuasistaticCompression, PrintedLawAgreesByChanceNearPoisson085) {
  const double chance = 4.0 / 3.0 * std::log(4.0) - 1.0;
  EXPECT_NEAR(chance, 0.848, 1e-3);
  EXPECT_NEAR(test::printed_compression(chance, 1e-3), compression(CompressionLaw::center, chance, 1e-3), 1e-17);
  // The shortening of the diameter does not depend on ν.
  EXPECT_EQ(compression(CompressionLaw::diameter, 0.9, 1e-3), compression(CompressionLaw::diameter, -0.9, 1e-3));
}

TEST(QuasistaticCompression, RefusesWhatTheLawDoesNotCover) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto law = CompressionLaw::center;
  const double limit = limit_force(law, 0.33);
  test::expect_refusal([] { (void)limit_force(CompressionLaw::diameter, 1.0); }, {"poisson", "0.995"});
  test::expect_refusal([&] { (void)limit_force(law, nan); }, {"poisson", "nan"});
  for (const double wrong : {-1e-9, 1.01 * limit, nan, std::numeric_limits<double>::infinity()}) {
    test::expect_refusal([&] { (void)compression(law, 0.33, wrong); }, {"force"});
    test::expect_refusal([&] { (void)compression_energy(law, 0.33, wrong); }, {"force"});
    test::expect_refusal([&] { (void)compression_force(law, 0.33, wrong); }, {"compression"});
  }
}

}  // namespace
}  // namespace stoss
