// Hertz' contact of round bodies: the closed stresses against Johnson's on the axis and on the surface, against
// equilibrium, and against the load they carry; far away against Boussinesq's point load.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "stoss/quasistatic/point_hertz.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

using std::numbers::pi;

TEST(PointHertz, IsHertzOfTwoBodies) {
  // A steel ball on glass in SI: Johnson, eqs. 4.22 to 4.24, as they stand.
  const double radius = 0.005, modulus = 1.0 / ((1.0 - 0.09) / 2.1e11 + (1.0 - 0.0484) / 7e10), force = 12.0;
  const PointPair pair{1.0 / radius, 1.0 / modulus};
  const PointHertz contact = point_hertz(pair, force);
  EXPECT_NEAR(contact.radius, std::pow(3.0 * force * radius / (4.0 * modulus), 1.0 / 3.0), 1e-14 * contact.radius);
  EXPECT_NEAR(contact.approach, std::pow(9.0 * force * force / (16.0 * radius * modulus * modulus), 1.0 / 3.0),
              1e-14 * contact.approach);
  EXPECT_NEAR(contact.pressure, std::pow(6.0 * force * modulus * modulus / (pi * pi * pi * radius * radius), 1.0 / 3.0),
              1e-14 * contact.pressure);
  boost::math::quadrature::tanh_sinh<double> integrate;
  const double energy =
      integrate.integrate([&](double d) { return point_hertz_of_approach(pair, d).force; }, 0.0, contact.approach);
  EXPECT_NEAR(contact.energy, energy, 1e-13 * energy);
  EXPECT_NEAR(point_hertz_of_approach(pair, contact.approach).force, force, 1e-13);
  const double load = integrate.integrate([&](double r) { return 2.0 * pi * r * point_hertz_pressure(contact, r); },
                                          0.0, contact.radius);
  EXPECT_NEAR(load, force, 1e-12);
  EXPECT_EQ(point_hertz_pressure(contact, contact.radius), 0.0);
  EXPECT_EQ(point_hertz({1.0, 1.0}, 0.0).radius, 0.0);
}

TEST(PointHertz, StressesAreJohnsonsOnAxisAndSurface) {
  const PointHertz contact = point_hertz({1.0, 0.91}, 1e-3);
  const double a = contact.radius, p = contact.pressure;
  for (const double nu : {-0.9, 0.0, 0.3, 0.4999}) {
    for (const double z : {1e-8, 0.1, 0.48, 1.0, 3.0}) {
      const AxisymmetricStress s = point_hertz_stress(contact, nu, z * a, 0.0);
      const double side = -(1.0 + nu) * (1.0 - z * std::atan(1.0 / z)) + 0.5 / (1.0 + z * z);
      EXPECT_NEAR(s.radial / p, side, 1e-14);
      EXPECT_NEAR(s.hoop / p, side, 1e-14);
      EXPECT_NEAR(s.axial / p, -1.0 / (1.0 + z * z), 1e-14);
      EXPECT_EQ(s.shear, 0.0);
    }
    for (const double r : {1e-3, 0.5, 0.999, 1.0, 1.001, 4.0}) {
      const AxisymmetricStress s = point_hertz_stress(contact, nu, 0.0, r * a);
      const double rest = std::max(0.0, (1.0 - r) * (1.0 + r)), root = std::sqrt(rest);
      const double b = (1.0 - 2.0 * nu) / (3.0 * r * r) * (1.0 - rest * root);
      EXPECT_NEAR(s.radial / p, b - root, 1e-9);  // of 1 − (1 − r²)^{3/2} here
      EXPECT_NEAR(s.hoop / p, -b - 2.0 * nu * root, 1e-9);
      EXPECT_NEAR(s.axial / p, -root, 1e-14);
      EXPECT_NEAR(s.shear / p, 0.0, 1e-14);
    }
  }
}

TEST(PointHertz, StressesAreInEquilibriumAndCarryTheLoad) {
  const PointHertz contact = point_hertz({1.0, 1.0}, 1e-3);
  const double a = contact.radius, nu = 0.3;
  const auto at = [&](double r, double z) { return point_hertz_stress(contact, nu, z * a, r * a); };
  constexpr double h = 1e-3;
  for (const double r : {0.3, 0.9, 1.1, 2.5}) {
    for (const double z : {0.2, 0.7, 2.0}) {
      const auto slope = [&](auto function, bool down) {
        const auto f = [&](double s) { return down ? function(at(r, z + s)) : function(at(r + s, z)); };
        return (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
      };
      const AxisymmetricStress s = at(r, z);
      const double across = slope([](const AxisymmetricStress& t) { return t.radial; }, false) +
                            slope([](const AxisymmetricStress& t) { return t.shear; }, true) + (s.radial - s.hoop) / r;
      const double down = slope([](const AxisymmetricStress& t) { return t.shear; }, false) +
                          slope([](const AxisymmetricStress& t) { return t.axial; }, true) + s.shear / r;
      EXPECT_NEAR(across / contact.pressure, 0.0, 1e-9) << r << " " << z;
      EXPECT_NEAR(down / contact.pressure, 0.0, 1e-9) << r << " " << z;
      // The sum of the normal stresses is harmonic, so that the strains are compatible.
      const auto trace = [](const AxisymmetricStress& t) { return t.radial + t.hoop + t.axial; };
      constexpr double k = 1e-2;
      const auto sum = [&](double dr, double dz) { return trace(at(r + dr, z + dz)) / contact.pressure; };
      const auto second = [&](double dr, double dz) {
        return (16.0 * (sum(dr, dz) + sum(-dr, -dz)) - sum(2.0 * dr, 2.0 * dz) - sum(-2.0 * dr, -2.0 * dz) -
                30.0 * sum(0.0, 0.0)) /
               (12.0 * k * k);
      };
      const double first = (8.0 * (sum(k, 0) - sum(-k, 0)) - (sum(2.0 * k, 0) - sum(-2.0 * k, 0))) / (12.0 * k);
      const double laplacian = second(k, 0.0) + second(0.0, k) + first / r;
      EXPECT_NEAR(laplacian, 0.0, 1e-4) << r << " " << z;
    }
  }
  boost::math::quadrature::tanh_sinh<double> integrate;
  for (const double z : {0.1, 1.0}) {
    // r = t/(1 − t)
    const double load = integrate.integrate(
        [&](double t) {
          const double r = t / (1.0 - t);
          return t < 1.0 ? -2.0 * pi * r * a * a * at(r, z).axial / ((1.0 - t) * (1.0 - t)) : 0.0;
        },
        0.0, 1.0 - 1e-7);
    EXPECT_NEAR(load / contact.force, 1.0, 1e-9);
  }
}

TEST(PointHertz, FarAwayIsAPointLoad) {
  const PointHertz contact = point_hertz({1.0, 1.0}, 1e-9);
  for (const double nu : {0.0, 0.3}) {
    for (const double z : {0.0, 0.2, 1.0}) {
      const double r = 1.0, rho = std::hypot(r, z), k = 1.0 - 2.0 * nu, load = contact.force / (2.0 * pi);
      // Johnson, eqs. 3.19.
      const double soft = k * (1.0 / (r * r) - z / (rho * r * r));
      const AxisymmetricStress s = point_hertz_stress(contact, nu, z, r);
      EXPECT_NEAR(s.radial / load, soft - 3.0 * z * r * r / std::pow(rho, 5.0), 1e-5);
      EXPECT_NEAR(s.hoop / load, -k * (1.0 / (r * r) - z / (rho * r * r) - z / std::pow(rho, 3.0)), 1e-5);
      EXPECT_NEAR(s.axial / load, -3.0 * z * z * z / std::pow(rho, 5.0), 1e-5);
      EXPECT_NEAR(s.shear / load, -3.0 * r * z * z / std::pow(rho, 5.0), 1e-5);
    }
  }
}

TEST(PointHertz, GreatestShearIsBelowTheSurface) {
  const PointHertz contact = point_hertz({1.0, 1.0}, 1e-3);
  const GreatestShear found = greatest_shear(contact, 0.3);
  EXPECT_NEAR(found.depth / contact.radius, 0.48, 0.002);
  EXPECT_NEAR(found.shear / contact.pressure, 0.310, 0.0005);
  const auto shear = [&](double z) {
    const AxisymmetricStress s = point_hertz_stress(contact, 0.3, z, 0.0);
    return 0.5 * (s.radial - s.axial);
  };
  EXPECT_NEAR(found.shear, shear(found.depth), 1e-16);
  EXPECT_GT(found.shear, shear(0.999 * found.depth));
  EXPECT_GT(found.shear, shear(1.001 * found.depth));
}

TEST(PointHertz, RefusesNonsense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  test::expect_refusal([] { (void)point_hertz({1.0, 1.0}, -1.0); }, {"force: got -1", "0 to 1e100"});
  test::expect_refusal([&] { (void)point_hertz({nan, 1.0}, 1.0); }, {"curvature"});
  test::expect_refusal([] { (void)point_hertz_of_approach({1.0, 0.0}, 1.0); }, {"softness"});
  const PointHertz contact = point_hertz({1.0, 1.0}, 1e-3);
  test::expect_refusal([&] { (void)point_hertz_stress(contact, 0.5, 0.1, 0.0); }, {"poisson: got 0.5"});
  test::expect_refusal([&] { (void)point_hertz_stress(contact, 0.3, -0.1, 0.0); }, {"depth"});
  test::expect_refusal([&] { (void)point_hertz_pressure(contact, -0.1); }, {"distance"});
}

}  // namespace
}  // namespace stoss
