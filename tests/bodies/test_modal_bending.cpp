// How a body of modes bends across its contact: hollow spheres, of which all is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bodies/modal/point_modes.hpp"
#include "bodies/sphere/hole/hole.hpp"
#include "stoss/bodies/hollow_sphere.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {
namespace {

using namespace bodies::sphere;

constexpr double poisson = 0.3, mass_of_sphere = 4.0 * std::numbers::pi / 3.0;

/// Displacement at the pole, and half its mean curvature, of a field with U = 1 or V = 1 at the surface.
double bend_of(int degree, double radial, double tangential) {
  const double wave = degree * (degree + 1.0);
  return 0.5 * wave * tangential - (0.25 * wave + 0.5) * radial;
}

/// A hollow sphere by its modes up to a frequency.
ModalBody by_modes(double inner, double highest) {
  ModalBody body;
  body.name = "shell";
  body.mass = mass_of_sphere * (1.0 - inner * inner * inner);
  body.curvature = body.young = body.density = 1.0;
  body.poisson = poisson;
  body.complete_to = highest;
  body.has_bends = true;
  body.compliance = bodies::modal::sphere_constant(poisson);
  const Hole hole(poisson, inner);
  for (const Flexibility& more : hole.excess({}).compliance) body.compliance += more.radial / mass_of_sphere;
  const double unit = 1.0 / std::sqrt(mass_of_sphere);
  for (const Mode& mode : hollow_modes(poisson, inner, highest)) {
    PointMode each;
    each.omega = mode.omega;
    each.displacement = unit * mode.radial;
    each.bend = unit * bend_of(mode.order, mode.radial, mode.tangential);
    body.modes.push_back(each);
  }
  std::sort(body.modes.begin(), body.modes.end(),
            [](const PointMode& a, const PointMode& b) { return a.omega < b.omega; });
  return body;
}

/// c₂ from the whole static response of each degree.
double exact_bending(double inner) {
  double sum = 0.0;
  const Hole hole(poisson, inner);
  const auto& excess = hole.excess({});
  for (std::size_t n = 0; n < excess.compliance.size(); ++n) {
    const Flexibility& more = excess.compliance[n];
    sum += bend_of(static_cast<int>(n), more.radial, more.mixed) / mass_of_sphere;
  }
  return sum;
}

}  // namespace

TEST(ModalBending, IsThatOfAllOfAShell) {
  struct Case {
    double inner, highest, off;
  };
  for (const Case& its : {Case{0.5, 8.0, 3e-3}, {0.5, 16.0, 1e-3}, {0.8, 11.0, 0.04}, {0.8, 23.0, 0.01}}) {
    const double exact = exact_bending(its.inner);
    const bodies::modal::Bending found = bodies::modal::bending(by_modes(its.inner, its.highest), {});
    EXPECT_NEAR(found.constant / exact, 1.0, its.off) << its.inner << " " << its.highest;
    EXPECT_LT(std::abs(found.constant - exact), 1.1 * found.doubt + 1e-3 * std::abs(exact)) << its.inner;
  }
}

TEST(ModalBending, IsNoneOfASphereAndOfAPlane) {
  const bodies::modal::Bending sphere = bodies::modal::bending(by_modes(0.0, 12.0), {});
  EXPECT_NEAR(sphere.constant, 0.0, 1e-9);
  EXPECT_NEAR(sphere.doubt, 0.0, 1e-9);
  ModalBody plane = by_modes(0.5, 8.0);
  plane.curvature = 0.0;
  EXPECT_EQ(bodies::modal::bending(plane, {}).constant, 0.0);
}

TEST(ModalBending, LetsAShellOfModesReboundAsItself) {
  for (const double inner : {0.5, 0.8, 0.9}) {
    for (const double speed : {1e-5, 1e-4, 1e-3}) {
      const auto lost = [speed](const BodyMaker& body) {
        try {
          return restitution(body, speed, {.tolerance = 1e-3, .absolute = 0.0}).lost_fraction;
        } catch (const RestitutionNotConverged& failure) {
          return failure.best.lost_fraction;
        }
      };
      const Estimate whole = lost(hollow_sphere({.poisson = poisson, .inner = inner}));
      const Estimate modes = lost(modal_body(by_modes(inner, 16.0)));
      EXPECT_LT(std::abs(modes.value - whole.value), modes.error + whole.error) << inner << " " << speed;
      EXPECT_LT(modes.error, 0.3 * whole.value);
    }
  }
}

}  // namespace stoss
