// A hollow sphere: its modes against determinants of Bessel's functions, its static response against closed forms and
// the sum over modes, and the limits of no hole and of a thin shell.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "bodies/sphere/hole/hole.hpp"
#include "bodies/sphere/hole/radial_shell.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "stoss/bodies/hollow_sphere.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using namespace bodies::sphere;

/// z_n and z_{n+1} of both kinds at x.
struct Wave {
  double value, next;
};
Wave wave(int kind, int n, double x) {
  const auto order = static_cast<unsigned>(n);
  if (kind == 0) return {boost::math::sph_bessel(order, x), boost::math::sph_bessel(order + 1, x)};
  return {boost::math::sph_neumann(order, x), boost::math::sph_neumann(order + 1, x)};
}

/// Tractions of the waves of both kinds at a face, over 2μ and times r²: σ_rr and σ_rθ by pressure and shear waves.
/// The formulas of EdgeProblem hold for any radial function.
Eigen::Matrix<double, 4, 4> tractions(double poisson, double inner, int n, double omega) {
  const WaveSpeeds speed = wave_speeds(poisson);
  const double wave_of = n * (n + 1.0);
  Eigen::Matrix<double, 4, 4> all;
  for (int face = 0; face < 2; ++face) {
    const double r = face == 0 ? inner : 1.0, k = omega / speed.pressure * r, s = omega / speed.shear * r;
    for (int kind = 0; kind < 2; ++kind) {
      const Wave p = wave(kind, n, k), t = wave(kind, n, s);
      const double alpha = n * p.value - k * p.next, alpha_s = n * t.value - s * t.next, y = 0.5 * s * s;
      all(2 * face, 2 * kind) = (wave_of - y) * p.value - 2.0 * alpha;
      all(2 * face, 2 * kind + 1) = wave_of * (alpha_s - t.value);
      all(2 * face + 1, 2 * kind) = alpha - p.value;
      all(2 * face + 1, 2 * kind + 1) = (wave_of - 1.0 - y) * t.value - alpha_s;
    }
  }
  // Columns and rows of about 1, which no zero of the determinant minds.
  for (int i = 0; i < 4; ++i) all.col(i) /= all.col(i).norm();
  for (int i = 0; i < 4; ++i) all.row(i) /= all.row(i).norm();
  return all;
}

double determinant(double poisson, double inner, int n, double omega) {
  if (n > 0) return tractions(poisson, inner, n, omega).determinant();
  const auto all = tractions(poisson, inner, 0, omega);  // pressure waves alone, whose σ_rr must vanish
  return all(0, 0) * all(2, 2) - all(0, 2) * all(2, 0);
}

double toroidal_determinant(double poisson, double inner, int n, double omega) {
  const auto at = [&](int kind, double r) {
    const double s = omega / wave_speeds(poisson).shear * r;
    const Wave its = wave(kind, n, s);
    return (n - 1.0) * its.value - s * its.next;
  };
  return at(0, inner) * at(1, 1.0) - at(1, inner) * at(0, 1.0);
}

template <typename Determinant>
int sign_changes(Determinant f, double low, double high) {
  constexpr int steps = 6000;
  int changes = 0;
  double last = f(low);
  for (int i = 1; i <= steps; ++i) {
    const double here = f(low + (high - low) * i / steps);
    if ((here < 0.0) != (last < 0.0)) ++changes;
    last = here;
  }
  return changes;
}

struct Shell {
  double inner, poisson;
};

TEST(HollowSphere, ModesAreTheZerosOfTheDeterminantOfBesselsFunctionsAndNoOthers_long) {
  constexpr double low = 0.05, cutoff = 12.0, near = 1e-8;
  for (const Shell& its : {Shell{0.9, 0.22}, {0.8, 0.3}, {0.5, 0.45}, {0.3, -0.5}, {0.2, 0.0}}) {
    const RadialShell shell(its.poisson, its.inner, cutoff, 30.0);
    for (const int n : {0, 1, 2, 3, 7, 12}) {
      const auto f = [&](double omega) { return determinant(its.poisson, its.inner, n, omega); };
      const auto modes = shell.modes(n, cutoff);
      EXPECT_EQ(sign_changes(f, low, cutoff), static_cast<int>(modes.size())) << its.inner << " " << n;
      for (const Mode& mode : modes) EXPECT_NE(f(mode.omega * (1.0 - near)) < 0.0, f(mode.omega * (1.0 + near)) < 0.0);
      if (n == 0) continue;
      const auto g = [&](double omega) { return toroidal_determinant(its.poisson, its.inner, n, omega); };
      const auto turning = shell.toroidal_modes(n, cutoff);
      EXPECT_EQ(sign_changes(g, low, cutoff), static_cast<int>(turning.size())) << its.inner << " " << n;
      for (const auto& mode : turning) {
        EXPECT_NE(g(mode.omega * (1.0 - near)) < 0.0, g(mode.omega * (1.0 + near)) < 0.0);
      }
    }
  }
}

TEST(HollowSphere, ModesDoNotDependOnHowMuchIsResolved) {
  for (const double inner : {0.02, 0.2, 0.5, 0.9, 0.99}) {
    const RadialShell shell(0.3, inner, 40.0, 40.0), finer(0.3, inner, 80.0, 80.0);
    for (const int n : {0, 1, 2, 5, 20, 45}) {
      const auto modes = shell.modes(n, 40.0), again = finer.modes(n, 40.0);
      ASSERT_EQ(modes.size(), again.size());
      for (std::size_t i = 0; i < modes.size(); ++i) {
        EXPECT_NEAR(modes[i].omega / again[i].omega, 1.0, 1e-10);
        const double size = std::hypot(again[i].radial, std::sqrt(n * (n + 1.0)) * again[i].tangential);
        EXPECT_NEAR(modes[i].radial, again[i].radial, 1e-9 * size);
      }
    }
  }
}

TEST(HollowSphere, StaticResponseIsThatOfAllModes) {
  constexpr double cutoff = 600.0;
  for (const Shell& its : {Shell{0.9, 0.3}, {0.6, -0.3}, {0.5, 0.45}}) {
    const RadialShell shell(its.poisson, its.inner, cutoff, cutoff);
    for (const int n : {0, 1, 2, 9}) {
      const auto whole = shell.response(n);
      Flexibility sum, moment;
      for (const Mode& mode : shell.modes(n, cutoff)) {
        const double square = 1.0 / (mode.omega * mode.omega);
        sum.radial += mode.radial * mode.radial * square;
        sum.mixed += mode.radial * mode.tangential * square;
        sum.tangential += mode.tangential * mode.tangential * square;
        moment.radial += mode.radial * mode.radial * square * square;
      }
      // What lies above: some (2n+1)/3 (2/πω_c)(1/c_p + 1/c_s).
      const double tail = (2.0 * n + 1.0) / 3.0 * 4.0 / (std::numbers::pi * cutoff) * 2.0;
      EXPECT_LT(sum.radial, whole.compliance.radial);
      EXPECT_NEAR(sum.radial, whole.compliance.radial, tail);
      EXPECT_NEAR(sum.mixed, whole.compliance.mixed, tail);
      EXPECT_NEAR(sum.tangential, whole.compliance.tangential, tail);
      EXPECT_NEAR(moment.radial, whole.second_moment.radial, 1e-6 * whole.second_moment.radial);
      if (n == 0) continue;
      double turning = 0.0;
      for (const auto& mode : shell.toroidal_modes(n, cutoff)) turning += std::pow(mode.amplitude / mode.omega, 2);
      EXPECT_NEAR(turning, shell.toroidal_response(n).compliance, tail);
    }
  }
}

TEST(HollowSphere, BreathesAsLameHasIt) {
  for (const Shell& its : {Shell{0.99, 0.3}, {0.5, 0.49}, {0.01, 0.3}, {1e-4, 0.0}}) {
    const double hole = std::pow(its.inner, 3), nu = its.poisson;
    const double exact = ((1.0 - 2.0 * nu) + 0.5 * (1.0 + nu) * hole) / (3.0 * (1.0 - hole));
    EXPECT_NEAR(RadialShell(nu, its.inner, 1.0, 1.0).response(0).compliance.radial / exact, 1.0, 1e-10);
  }
}

TEST(HollowSphere, WithoutAHoleIsTheSphere) {
  const Body solid = sphere(Sphere{0.3}, 20.0);
  const auto weight = [](const Body& body) {
    double sum = 0.0;
    for (const ModeGroup& group : body.groups) {
      for (std::size_t l = 0; l < group.omega.size(); ++l) sum += group.omega[l] * std::abs(group.upper[l]);
    }
    return sum;
  };
  EXPECT_EQ(weight(hollow_sphere({0.3, 0.0})(20.0, {})), weight(solid));
  for (const double inner : {1e-7, 1e-4}) {  // what a hole changes is its volume
    const Body body = hollow_sphere({0.3, inner})(20.0, {});
    EXPECT_EQ(mode_count(body), mode_count(solid));
    EXPECT_NEAR(weight(body) / weight(solid), 1.0, 1e-10);
    const ContactPoints points{1.0, 0.05, 12};
    const auto one = body.residual_compliance(points, {}), other = solid.residual_compliance(points, {});
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], 1e-11 * other.front());
  }
}

// Of the middle face a = (1 + b)/2 without bending: breathing, ω² = 2/(1 − ν), and H. Lamb, Proc. Lond. Math. Soc. 14,
// 50 (1882), Ω⁴ − Ω²(1 + 3ν + N) + (1 − ν²)(N − 2) = 0, Ω² = ω²(1 − ν²).
TEST(HollowSphere, VibratesAsAMembraneWhereItIsThin) {
  constexpr double inner = 0.99, middle = 0.5 * (1.0 + inner), nu = 0.3;
  const RadialShell shell(nu, inner, 10.0, 10.0);
  EXPECT_NEAR(std::pow(middle * shell.modes(0, 10.0).front().omega, 2), 2.0 / (1.0 - nu), 1e-3);
  for (const int n : {2, 3}) {
    const double wave = n * (n + 1.0), sum = 1.0 + 3.0 * nu + wave, product = (1.0 - nu * nu) * (wave - 2.0);
    const double lowest = 0.5 * (sum - std::sqrt(sum * sum - 4.0 * product)) / (1.0 - nu * nu);
    EXPECT_NEAR(std::pow(middle * shell.modes(n, 10.0).front().omega, 2) / lowest, 1.0, 4e-3);
    const double turning = 0.5 / (1.0 + nu) * (wave - 2.0);
    EXPECT_NEAR(std::pow(middle * shell.toroidal_modes(n, 10.0).front().omega, 2) / turning, 1.0, 1e-3);
  }
}

// E. Reissner, J. Math. Phys. 25, 279 (1946): a point load F moves a shallow shell by √(3(1 − ν²))/4 · FR/(Eh²).
TEST(HollowSphere, IsAsSoftAsReissnersShellWhereItIsThin) {
  constexpr double nu = 0.3;
  double last = 1.0;
  for (const double inner : {0.98, 0.99}) {
    const Body body = hollow_sphere({nu, inner})(1e-3, {});
    const double thickness = 1.0 - inner, middle = 0.5 * (1.0 + inner);
    // On a ring as wide as the shell is thick, which tells nothing of how it is squeezed there.
    const double compliance = body.residual_compliance({1.0, 2.0 * thickness, 1}, {}).front();
    const double shallow = 0.25 * std::sqrt(3.0 * (1.0 - nu * nu)) * middle / (thickness * thickness);
    const double off = std::abs(compliance / shallow - 1.0);
    EXPECT_LT(off, 0.06);
    EXPECT_LT(off, last);
    last = off;
  }
}

TEST(HollowSphere, HasTheMassAndTheInertiaOfAShell) {
  const Body body = hollow_sphere({.poisson = 0.3, .inner = 0.9, .radius = 2.0, .density = 3.0})(10.0, {});
  const double mass = 4.0 / 3.0 * std::numbers::pi * (1.0 - 0.729);
  EXPECT_NEAR(body.mass, mass, 1e-14);
  EXPECT_NEAR(body.scale.mass, mass * 24.0, 1e-12);
  EXPECT_NEAR(body.inertia / body.mass, 0.4 * (1.0 - std::pow(0.9, 5)) / (1.0 - std::pow(0.9, 3)), 1e-14);
  EXPECT_NEAR(hollow_sphere({0.3, 0.99})(10.0, {}).inertia / hollow_sphere({0.3, 0.99})(10.0, {}).mass, 2.0 / 3.0,
              0.01);
}

TEST(HollowSphere, ResponseIsPositiveDefinite) {
  for (const double inner : {0.3, 0.9, 0.99}) {
    for (const double cutoff : {0.5, 20.0}) {
      const Body body = hollow_sphere({0.35, inner})(cutoff, {});
      std::vector<Body> all{body, body.along({}).front(), body.outward({})};
      for (const Body& each : all) {
        const ContactPoints points{1.0, 0.02, 16};
        const auto rows = static_cast<Eigen::Index>(each.components * points.count);
        const auto compliance = each.residual_compliance(points, {});
        const Eigen::MatrixXd matrix = Eigen::Map<const Eigen::MatrixXd>(compliance.data(), rows, rows);
        EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-12 * matrix.norm());
        EXPECT_EQ(matrix.llt().info(), Eigen::Success) << inner << " " << cutoff;
      }
    }
  }
}

TEST(HollowSphere, ListsItsModesAsTheSphereDoes) {
  const std::vector<Mode> listed = hollow_modes(0.3, 0.9, 6.0), solid = modes(0.3, 6.0);
  const std::vector<Mode> none = hollow_modes(0.3, 0.0, 6.0);
  ASSERT_EQ(none.size(), solid.size());
  for (std::size_t k = 0; k < solid.size(); ++k) EXPECT_EQ(none[k].omega, solid[k].omega);
  ASSERT_EQ(listed.front().order, 0);
  // It breathes as a membrane, with a displacement that hardly depends on r.
  EXPECT_NEAR(listed.front().omega, std::sqrt(2.0 / 0.7) / 0.95, 2e-3);
  EXPECT_NEAR(listed.front().radial, std::sqrt(1.0 / (1.0 - 0.729)), 0.05 * listed.front().radial);
  for (std::size_t k = 1; k < listed.size(); ++k) {
    const Mode &before = listed[k - 1], &mode = listed[k];
    EXPECT_TRUE(before.order < mode.order || (before.order == mode.order && before.omega < mode.omega));
    EXPECT_NEAR(determinant(0.3, 0.9, mode.order, mode.omega), 0.0, 1e-6) << mode.order << " " << mode.omega;
  }
  EXPECT_THROW((void)hollow_modes(0.3, 1.0, 6.0), InvalidInput);
  EXPECT_THROW((void)hollow_modes(0.3, 0.9, 401.0), InvalidInput);
  EXPECT_THROW((void)hollow_modes(0.3, 0.9, 0.1), InvalidInput);  // below the lowest mode
  EXPECT_THROW((void)hollow_modes(0.5, 0.9, 6.0), InvalidInput);
}

TEST(HollowSphere, RefusesWhatIsOutOfRange) {
  EXPECT_THROW((void)hollow_sphere({0.3, 1.0}), InvalidInput);
  EXPECT_THROW((void)hollow_sphere({0.3, -0.1}), InvalidInput);
  EXPECT_THROW((void)hollow_sphere({0.5, 0.9}), InvalidInput);
  EXPECT_THROW((void)hollow_sphere({0.3, 0.9})(401.0, {}), InvalidInput);
}

}  // namespace
}  // namespace stoss
