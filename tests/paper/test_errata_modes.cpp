// The errata of the paper's modes (docs/theory/errata.md) that no other test shows.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/bessel_prime.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/field.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/contact/grid.hpp"
#include "support/body_tools.hpp"

namespace stoss {
using namespace bodies::disk;
namespace {

using std::numbers::pi;
using Gauss = boost::math::quadrature::gauss<double, 30>;

/// ∫_0^1 f(r) dr.
template <typename Function>
double over_radius(const Function& f) {
  return Gauss::integrate(f, 0.0, 1.0);
}

TEST(Errata, E1EnergyOfAModeHasTheFactorOneHalf) {
  const double poisson = 0.33;
  const Body body = disk(poisson, 6.0);
  const ContactGrid contact = test::grid_of(body, 0.5, 20);
  const std::vector<double> no_force(contact.coordinate.size(), 0.0);
  constexpr int angles = 32;  // enough for the squares of all orders below the cutoff
  std::vector<double> angle;
  for (int i = 0; i < angles; ++i) angle.push_back(2.0 * pi * i / angles - pi);

  std::size_t mode = 0;
  for (const ModeGroup& group : body.groups) {
    for (const double omega : group.omega) {
      ASSERT_LT(2 * group.order, angles);
      std::vector<double> coordinate(mode_count(body), 0.0);
      coordinate[mode++] = 1.0;
      // ½ ∫ σ:ε of the mode at rest with Q = 1, with E = 1.
      const double energy = over_radius([&](double r) {
        const Field at = DiskField(poisson, body, contact.points, {{r}, angle}).at(coordinate, no_force);
        double sum = 0.0;
        for (std::size_t i = 0; i < angle.size(); ++i) {
          const double rr = at.stress_rr[i], pp = at.stress_pp[i], rp = at.stress_rp[i];
          sum += rr * rr + pp * pp - 2.0 * poisson * rr * pp + 2.0 * (1.0 + poisson) * rp * rp;
        }
        return 0.5 * r * sum * 2.0 * pi / angles;
      });
      EXPECT_NEAR(energy / (body.mass * omega * omega), 0.5, 1e-11) << "order " << group.order;
    }
  }
  EXPECT_GT(mode, 10U);
}

/// ∫ r u·u dr of the modes (n, 0) and (n, 1), normalised, with u from eq. (19), or with κ and κ′ exchanged in u_φ.
double overlap(int n, bool as_printed) {
  using boost::math::cyl_bessel_j;
  using boost::math::cyl_bessel_j_prime;
  const double poisson = 0.33;
  const auto field = [&](const Mode& mode, double r) {
    const double k = mode.omega * std::sqrt(1.0 - poisson * poisson);
    const double shear = mode.omega * std::sqrt(2.0 * (1.0 + poisson));
    // A : B from the vanishing shear stress at the edge, eq. (22).
    const double a =
        2.0 * shear * cyl_bessel_j_prime(n, shear) + (shear * shear - 2.0 * n * n) * cyl_bessel_j(n, shear);
    const double b = 2.0 * n * (k * cyl_bessel_j_prime(n, k) - cyl_bessel_j(n, k));
    const double first = as_printed ? shear : k;
    const double second = as_printed ? k : shear;
    return std::array{a * k * cyl_bessel_j_prime(n, k * r) + n * b * cyl_bessel_j(n, shear * r) / r,
                      -n * a * cyl_bessel_j(n, first * r) / r - b * second * cyl_bessel_j_prime(n, second * r)};
  };
  std::vector<Mode> modes;
  for (const Mode& mode : bodies::disk::modes(poisson, 12.0)) {
    if (mode.order == n) modes.push_back(mode);
  }
  const auto product = [&](const Mode& one, const Mode& other) {
    return over_radius([&](double r) {
      const auto u = field(one, r), w = field(other, r);
      return r * (u[0] * w[0] + u[1] * w[1]);
    });
  };
  return product(modes[0], modes[1]) / std::sqrt(product(modes[0], modes[0]) * product(modes[1], modes[1]));
}

TEST(Errata, E4PrintedFieldsAreNotOrthogonal) {
  constexpr std::array printed{0.04, 0.56, 0.71};
  for (const int n : {1, 2, 3}) {
    EXPECT_NEAR(std::abs(overlap(n, true)), printed[static_cast<std::size_t>(n - 1)], 0.005) << n;
    EXPECT_NEAR(overlap(n, false), 0.0, 1e-12) << n;
  }
}

TEST(Errata, E10DilatationHasTheOppositeSign) {
  // In the mode (0, l), u_r = A dJ_0(κr)/dr: the paper prints η = +Aκ²J_0.
  for (const Mode& mode : bodies::disk::modes(0.33, 12.0)) {
    if (mode.order != 0) continue;
    const double k = mode.omega * std::sqrt(1.0 - 0.33 * 0.33), r = 0.3, h = 1e-3;
    const auto field = displacement(0.33, mode, {r - h, r, r + h});
    const double dilatation = (field[2].radial - field[0].radial) / (2.0 * h) + field[1].radial / r;
    const double amplitude = field[1].radial / (k * boost::math::cyl_bessel_j_prime(0, k * r));
    const double printed = amplitude * k * k * boost::math::cyl_bessel_j(0, k * r);
    EXPECT_NEAR(dilatation / printed, -1.0, k * k * h * h);
  }
}

}  // namespace
}  // namespace stoss
