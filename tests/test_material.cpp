// SI ↔ dimensionless, plane stress and plane strain.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/material.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

constexpr Material steel{2.1e11, 0.3, 7850.0};

TEST(MaterialPoisson, PlaneStressKeepsItAndPlaneStrainMapsIt) {
  EXPECT_EQ(plane_poisson(steel, Plane::stress), 0.3);
  EXPECT_DOUBLE_EQ(plane_poisson(steel, Plane::strain), 3.0 / 7.0);
  EXPECT_DOUBLE_EQ(plane_poisson({1e6, 0.4975, 1000.0}, Plane::strain), 0.4975 / 0.5025);
  EXPECT_DOUBLE_EQ(plane_poisson({1e6, -0.5, 1000.0}, Plane::strain), -1.0 / 3.0);
}

TEST(MaterialQuality, IsThatOfAModeAtItsFrequency) {
  EXPECT_DOUBLE_EQ(loss_time_of_quality(50.0, 4.0), 0.005);
  // A mode ω loses 2π/Q of its energy per period: γ = ηω²/2, and e^{−2γ 2π/ω} = 1 − 2π/Q + …
  const double omega = 3.0, quality = 1e6, gamma = 0.5 * loss_time_of_quality(quality, omega) * omega * omega;
  EXPECT_NEAR(-std::expm1(-4.0 * std::numbers::pi * gamma / omega) * quality / (2.0 * std::numbers::pi), 1.0, 1e-5);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, infinite}) {
    EXPECT_THROW((void)loss_time_of_quality(bad, 1.0), InvalidInput) << bad;
    EXPECT_THROW((void)loss_time_of_quality(1.0, bad), InvalidInput) << bad;
  }
}

TEST(MaterialScales, AreThoseOfTheBarWave) {
  const Scales s = scales(steel, Plane::stress, 0.05);
  EXPECT_DOUBLE_EQ(s.length, 0.05);
  EXPECT_NEAR(s.speed, 5172.194154, 1e-5);  // √(2.1e11 / 7850) m/s
  EXPECT_DOUBLE_EQ(s.time, 0.05 / s.speed);
  EXPECT_DOUBLE_EQ(s.frequency, s.speed / 0.05);
  EXPECT_DOUBLE_EQ(s.force, std::numbers::pi * 0.05 * 2.1e11);
  // mc²/R per thickness, with m = πR²ρ
  EXPECT_NEAR(s.force / (std::numbers::pi * 0.05 * 7850.0 * s.speed * s.speed), 1.0, 1e-14);
}

TEST(MaterialScales, OfARodAreThoseOfItsCrossSection) {
  const Rod rod{0.5, steel.young, steel.density, 1e-4};
  const Scales s = scales(rod);
  EXPECT_NEAR(s.speed, 5172.194154, 1e-5);
  EXPECT_DOUBLE_EQ(s.length, 0.5);
  EXPECT_DOUBLE_EQ(s.time * s.speed, 0.5);
  EXPECT_DOUBLE_EQ(s.frequency * s.time, 1.0);
  EXPECT_NEAR(s.force, 2.1e7, 1e-6);
  const double mass = 7850.0 * 0.5 * 1e-4;  // mc²/L
  EXPECT_NEAR(s.force / (mass * s.speed * s.speed / 0.5), 1.0, 1e-14);
  EXPECT_THROW((void)scales(Rod{0.5, -1.0, 7850.0, 1e-4}), InvalidInput);
}

TEST(MaterialScales, OfASphereAreThoseOfItsMass) {
  const Scales s = scales(Sphere{steel.poisson, 0.01, steel.young, steel.density});
  EXPECT_NEAR(s.speed, 5172.194154, 1e-5);
  EXPECT_DOUBLE_EQ(s.length, 0.01);
  EXPECT_DOUBLE_EQ(s.time * s.speed, 0.01);
  EXPECT_DOUBLE_EQ(s.frequency * s.time, 1.0);
  const double mass = 4.0 / 3.0 * std::numbers::pi * 1e-6 * 7850.0;  // 33 g
  EXPECT_NEAR(s.force / (mass * s.speed * s.speed / 0.01), 1.0, 1e-14);
  EXPECT_THROW((void)scales(Sphere{0.3, -1.0, 2.1e11, 7850.0}), InvalidInput);
  EXPECT_THROW((void)scales(Sphere{0.5, 0.01, 2.1e11, 7850.0}), InvalidInput);
}

TEST(MaterialScales, OfPlaneStrainUseTheStifferModulus) {
  const Scales s = scales(steel, Plane::strain, 0.05);
  EXPECT_NEAR(s.speed * s.speed * 7850.0 / 2.1e11, 1.0 / 0.91, 1e-13);
  EXPECT_NEAR(s.force / (std::numbers::pi * 0.05 * 2.1e11), 1.0 / 0.91, 1e-13);
}

TEST(MaterialScales, PlaneStrainGivesTheSolidsOwnWaves) {
  // E′ and ν′ of plane strain must give the pressure and shear wave speeds of the three-dimensional solid.
  const double nu = steel.poisson, mapped = plane_poisson(steel, Plane::strain);
  const double c = scales(steel, Plane::strain, 1.0).speed;
  const double modulus = steel.young / steel.density;
  EXPECT_NEAR(c / std::sqrt(1.0 - mapped * mapped), std::sqrt(modulus * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu))),
              1e-9 * c);
  EXPECT_NEAR(c / std::sqrt(2.0 * (1.0 + mapped)), std::sqrt(modulus / (2.0 * (1.0 + nu))), 1e-9 * c);
}

TEST(MaterialScales, FitTogether) {
  const Scales s = scales({5.7e6, 0.41, 1130.0}, Plane::strain, 0.012);
  EXPECT_NEAR(s.time * s.frequency, 1.0, 1e-15);
  EXPECT_NEAR(s.length / s.time / s.speed, 1.0, 1e-15);
  const double mass = std::numbers::pi * 0.012 * 0.012 * 1130.0;  // per thickness
  EXPECT_NEAR(s.force * s.time / (mass * s.speed), 1.0, 1e-15);
}

/// An impact of a disk at a hard wall, from SI to SI.
struct ImpactInSi {
  double restitution, contact_time, max_force, max_compression;

  ImpactInSi(const Material& material, Plane plane, double radius, double metres_per_second) {
    const Scales unit = scales(material, plane, radius);
    const Impact result =
        impact(disk(plane_poisson(material, plane), 12.5), HardWall{}, metres_per_second / unit.speed);
    restitution = result.restitution;
    contact_time = result.contact_time * unit.time;
    max_force = result.max_force * unit.force;
    max_compression = result.max_compression * unit.length;
  }
};

TEST(MaterialScales, ImpactsAreSimilarAsDimensionsAsk) {
  for (const Plane plane : {Plane::stress, Plane::strain}) {
    const ImpactInSi one({3.1e9, 0.35, 1234.5}, plane, 0.037, 20.0);
    // Stiffness × 4 and density / 4 make all waves four times faster; then twice the size.
    const ImpactInSi other({4.0 * 3.1e9, 0.35, 0.25 * 1234.5}, plane, 2.0 * 0.037, 4.0 * 20.0);
    EXPECT_DOUBLE_EQ(other.restitution, one.restitution);
    EXPECT_DOUBLE_EQ(other.contact_time, 0.5 * one.contact_time);
    EXPECT_DOUBLE_EQ(other.max_force, 8.0 * one.max_force);  // per thickness: stiffness times length
    EXPECT_DOUBLE_EQ(other.max_compression, 2.0 * one.max_compression);
    const ImpactInSi faster({3.1e9, 0.35, 1234.5}, plane, 0.037, 80.0);
    EXPECT_LT(faster.restitution, one.restitution - 0.01);
  }
}

TEST(MaterialInput, IsRefusedOutOfRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::nan("");
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    test::expect_refusal([&] { (void)scales({bad, 0.3, 1.0}, Plane::stress, 1.0); }, {"young", "got", "above 0"});
    test::expect_refusal([&] { (void)scales({1.0, 0.3, bad}, Plane::stress, 1.0); }, {"density", "got", "above 0"});
    test::expect_refusal([&] { (void)scales({1.0, 0.3, 1.0}, Plane::stress, bad); }, {"radius", "got", "above 0"});
    test::expect_refusal([&] { (void)plane_poisson({bad, 0.3, 1.0}, Plane::stress); }, {"young", "got", "above 0"});
  }
  for (const double bad : {-1.0, 0.5, 0.7, nan, infinity}) {
    for (const Plane plane : {Plane::stress, Plane::strain}) {
      test::expect_refusal([&] { (void)plane_poisson({1.0, bad, 1.0}, plane); }, {"poisson", "below 0.5"});
      test::expect_refusal([&] { (void)scales({1.0, bad, 1.0}, plane, 1.0); }, {"poisson", "below 0.5"});
    }
  }
}

}  // namespace
}  // namespace stoss
