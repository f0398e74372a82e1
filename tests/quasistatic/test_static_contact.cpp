// The static contact of a disk with a hard wall: against a spectral solution of the same problem, and
// against the laws of compression.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "stoss/quasistatic/compression.hpp"
#include "stoss/quasistatic/static_contact.hpp"
#include "support/printed_law.hpp"
#include "support/refusal.hpp"
#include "support/spectral_contact.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

using std::numbers::pi;

TEST(QuasistaticStaticContact, IsTheSpectralSolution_long) {
  for (const double poisson : {-0.5, 0.0, 0.33, 0.9}) {
    for (const double a : {0.06, 0.2, 0.4}) {
      const test::SpectralContact exact(poisson, a);
      const StaticContact contact = static_contact(poisson, exact.compression);
      EXPECT_NEAR(contact.force / exact.force, 1.0, 2e-6) << poisson << " " << a;
      EXPECT_LT(std::abs(contact.force - exact.force), contact.force_error);
      EXPECT_LT(contact.force_error, 1.5e-5 * contact.force);
      EXPECT_NEAR(contact.energy / exact.energy, 1.0, 2e-8) << poisson << " " << a;
      EXPECT_NEAR(contact.half_width / a, 1.0, 1e-4) << poisson << " " << a;
      for (std::size_t i = 0; i < contact.position.size(); ++i) {
        const bool inside = contact.position[i] < 0.95 * a;
        EXPECT_NEAR(contact.pressure[i], exact.pressure(contact.position[i]), (inside ? 2e-4 : 2e-2) * 0.5 * a)
            << contact.position[i] / a;
      }
    }
  }
}

TEST(QuasistaticStaticContact, ConvergesWithTheSquareOfTheNodes) {
  for (const double poisson : {0.0, 0.33, 0.9}) {
    const test::SpectralContact exact(poisson, 0.2);
    // Where the contact ends between two nodes makes the error uneven, so the order is that over a factor of 16.
    const auto error = [&](int nodes) {
      const StaticContact contact = static_contact(poisson, exact.compression, {.nodes = nodes});
      EXPECT_LT(std::abs(contact.force - exact.force), contact.force_error) << nodes;
      return std::abs(contact.force / exact.force - 1.0);
    };
    const auto energy_error = [&](int nodes) {
      return std::abs(static_contact(poisson, exact.compression, {.nodes = nodes}).energy / exact.energy - 1.0);
    };
    const double order = std::log2(error(20) / error(320)) / 4.0;
    EXPECT_GT(order, 1.7) << poisson;
    EXPECT_LT(order, 2.6) << poisson;
    EXPECT_NEAR(std::log2(energy_error(20) / energy_error(160)) / 3.0, 3.0, 0.4) << poisson;
  }
}

TEST(QuasistaticStaticContact, SatisfiesTheConditionsAndTheBooks) {
  for (const double delta : {1e-12, 1e-4, 0.03, 0.5}) {
    const StaticContact contact = static_contact(0.33, delta);
    double load = 0.0;
    int touching = 0;
    for (std::size_t i = 0; i < contact.position.size(); ++i) {
      EXPECT_GE(contact.pressure[i], 0.0);
      EXPECT_NEAR(contact.position[i], (static_cast<double>(i) + 0.5) * contact.spacing, 1e-15);
      load += 2.0 * contact.spacing * contact.pressure[i];
      touching += contact.pressure[i] > 0.0 ? 1 : 0;
    }
    EXPECT_NEAR(load, pi * contact.force, 1e-13 * load);
    EXPECT_EQ(touching, contact.contact_nodes);
    EXPECT_EQ(contact.compression, delta);
    EXPECT_EQ(contact.poisson, 0.33);
    EXPECT_NEAR(contact.contact_nodes, 160, 3);
  }
}

struct Deviation {
  double poisson, compression;
  double in_compression, in_force;            // of the law for the centre: δ at the force, F at the compression
  double printed_compression, printed_force;  // of the paper's law
};

TEST(QuasistaticStaticContact, TellsHowGoodTheLawsAre) {
  // δ: docs/theory/errata.md, E8. The force deviates more, by the factor u/(u − 1) of the logarithm.
  constexpr Deviation table[] = {
      {0.0, 0.01, -0.00078, 0.00094, 0.1022, -0.1076},  {0.0, 0.03, -0.00378, 0.00478, 0.1273, -0.1360},
      {0.33, 0.01, -0.00094, 0.00113, 0.0630, -0.0696}, {0.33, 0.03, -0.00458, 0.00583, 0.0772, -0.0881},
      {0.9, 0.01, -0.00124, 0.00149, -0.0078, 0.0095},  {0.9, 0.03, -0.00612, 0.00790, -0.0146, 0.0190},
  };
  for (const Deviation& row : table) {
    const StaticContact exact = static_contact(row.poisson, row.compression);
    const auto law = CompressionLaw::center;
    const double delta = compression(law, row.poisson, exact.force);
    const double force = compression_force(law, row.poisson, row.compression);
    const double printed = test::printed_compression(row.poisson, exact.force);
    EXPECT_NEAR(delta / row.compression - 1.0, row.in_compression, 1e-5) << row.poisson;
    EXPECT_NEAR(force / exact.force - 1.0, row.in_force, 1e-5) << row.poisson;
    EXPECT_NEAR(printed / row.compression - 1.0, row.printed_compression, 1e-4) << row.poisson;
    EXPECT_NEAR(test::printed_force(row.poisson, row.compression) / exact.force - 1.0, row.printed_force, 1e-4);
  }
}

TEST(QuasistaticStaticContact, LawForTheCentreIsExactForSmallLoadsWithAKnownNextTerm_long) {
  // δ = law + (3 + 3ν/2) F² + …: the coefficient is a measurement (docs/theory/quasistatic.md).
  for (const double poisson : {-0.5, 0.0, 0.33, 0.9}) {
    const test::SpectralContact exact(poisson, 0.04);
    const double rest = exact.compression - compression(CompressionLaw::center, poisson, exact.force);
    EXPECT_NEAR(rest / (exact.force * exact.force), 3.0 + 1.5 * poisson, 0.01) << poisson;
  }
  for (const double delta : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const double law = compression_force(CompressionLaw::center, 0.33, delta);
    EXPECT_NEAR(static_contact(0.33, delta).force / law, 1.0, 0.06 * delta + 1e-6) << delta;
  }
}

TEST(QuasistaticStaticContact, RefusesWhatItIsNotMeantFor) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {0.0, -0.01, 0.51, nan}) {
    test::expect_refusal([&] { (void)static_contact(0.33, wrong); }, {"compression", "1e-12 to 0.5"});
  }
  test::expect_refusal([&] { (void)static_contact(1.0, 0.01); }, {"poisson"});
  test::expect_refusal([&] { (void)static_contact(0.33, 0.01, {.nodes = 15}); }, {"nodes", "15", "16 to 1024"});
  test::expect_refusal([&] { (void)static_contact(0.33, 0.01, {.nodes = 1025}); }, {"nodes"});
}

}  // namespace
}  // namespace stoss
