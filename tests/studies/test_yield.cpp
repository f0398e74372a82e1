// Finite elements of studies/yield against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "yield/hertz.hpp"
#include "yield/indentation.hpp"

namespace {

using namespace yield_study;

constexpr double never = std::numeric_limits<double>::infinity();

/// Rectangle a < r < b, 0 < z < h of bilinear elements whose inner nodes are moved; every displacement is an unknown.
Mesh rectangle(double a, double b, double h, int count) {
  Mesh mesh;
  for (int k = 0; k <= count; ++k)
    for (int i = 0; i <= count; ++i) {
      const bool inner = i > 0 && i < count && k > 0 && k < count;
      const double shift = inner ? 0.15 * std::sin(5.0 * i + 3.0 * k) : 0.0;
      mesh.nodes.emplace_back(a + (b - a) * (i + shift) / count, h * (k + 0.7 * shift) / count);
    }
  for (int k = 0; k < count; ++k)
    for (int i = 0; i < count; ++i) {
      const int corner = k * (count + 1) + i;
      mesh.elements.push_back({corner, corner + 1, corner + count + 2, corner + count + 1});
    }
  return mesh;
}

std::vector<Freedom> all_free(const Mesh& mesh) {
  std::vector<Freedom> freedoms;
  for (int k = 0; k < 2 * static_cast<int>(mesh.nodes.size()); ++k) freedoms.push_back({k, 1.0});
  return freedoms;
}

TEST(YieldPlasticity, ReturnsToTheYieldSurfaceAlongTheDeviator) {
  const Material material{200.0, 0.3, 1.0};
  const Stress trial(3.0, -1.0, 0.5, 1.2);
  const Returned returned = radial_return(material, trial);
  EXPECT_NEAR(mises(returned.stress), 1.0, 1e-12);
  EXPECT_NEAR(returned.stress.head<3>().sum(), trial.head<3>().sum(), 1e-12);  // flow keeps the volume
  EXPECT_NEAR(returned.slip, (mises(trial) - 1.0) / (3.0 * material.shear()), 1e-15);
  const Returned inside = radial_return(material, 0.1 * trial);
  EXPECT_EQ(inside.stress, Stress(0.1 * trial));
  EXPECT_EQ(inside.slip, 0.0);
}

TEST(YieldPlasticity, HasTheTangentOfItsStress) {
  const Material material{200.0, 0.3, 1.0};
  const Stress strain(0.012, -0.004, 0.001, 0.009);
  const auto stress = [&](const Stress& of) { return radial_return(material, material.stiffness() * of).stress; };
  const Stiffness tangent = radial_return(material, material.stiffness() * strain).tangent;
  EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-10);
  for (int k = 0; k < 4; ++k) {
    Stress step = Stress::Zero();
    step[k] = 1e-7;
    const Stress slope = (stress(strain + step) - stress(strain - step)) / 2e-7;
    EXPECT_LT((slope - tangent.col(k)).norm(), 1e-5 * material.young) << k;
  }
}

/// ½σ:C⁻¹:σ.
TEST(YieldPlasticity, StoresElasticEnergy) {
  const Material material{200.0, 0.3, never};
  const Stress strain(0.012, -0.004, 0.001, 0.009), stress = material.stiffness() * strain;
  EXPECT_NEAR(elastic_energy(material, stress), 0.5 * stress.dot(strain), 1e-12);
}

/// A bar that is pulled follows E ε up to Y, then Y, and comes back with E.
TEST(YieldBody, FollowsABarInTension) {
  const Material material{1.0, 0.3, 0.01};
  const Mesh mesh = rectangle(0.0, 1.0, 2.0, 4);
  std::vector<Freedom> freedoms = all_free(mesh);
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
    if (mesh.nodes[k][0] == 0.0) freedoms[2 * k].unknown = -1;
  int next = 0;
  for (Freedom& freedom : freedoms)
    if (freedom.unknown >= 0) freedom.unknown = next++;
  Body body(mesh, material, freedoms);
  Newton newton(body);
  std::vector<char> held(static_cast<std::size_t>(body.size()), 0);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(body.size()), unknowns = values;
  const Eigen::VectorXd none = values;
  for (const double strain : {0.005, 0.0099, 0.015, 0.03, 0.025}) {
    for (std::size_t k = 0; k < mesh.nodes.size(); ++k) {
      const int of = body.freedom(static_cast<int>(k), 1).unknown;
      if (mesh.nodes[k][1] != 0.0 && mesh.nodes[k][1] != 2.0) continue;
      held[static_cast<std::size_t>(of)] = 1;
      values[of] = strain * mesh.nodes[k][1];
    }
    solve(body, newton, unknowns, held, values, none);
    const double expected = strain == 0.025 ? 0.01 - 0.005 : std::min(strain, 0.01);
    for (int element = 0; element < 16; ++element)
      for (int point = 0; point < 4; ++point)
        EXPECT_LT((body.stress(element, point) - Stress(0.0, expected, 0.0, 0.0)).norm(), 1e-8) << strain;
  }
}

/// A thick sphere b = 2 a under inner pressure, plastic out to c (Hill, The Mathematical Theory of Plasticity, ch.
/// V.2): p = 2Y ln(c/a) + (2Y/3)(1 − c³/b³), and outside u(b) = (Y/E)(1 − ν) c³/b². It does not lock at ν near ½.
void check_thick_sphere(double poisson) {
  const double a = 1.0, b = 2.0, c = 1.4, strength = 0.01;
  const Material material{1.0, poisson, strength};
  constexpr int radial = 32, around = 24;
  Mesh mesh;
  std::vector<Freedom> freedoms;
  int next = 0;
  for (int k = 0; k <= around; ++k)
    for (int i = 0; i <= radial; ++i) {
      const double angle = 0.5 * std::numbers::pi * k / around, at = a + (b - a) * i / radial;
      mesh.nodes.emplace_back(k == around ? 0.0 : at * std::cos(angle), k == 0 ? 0.0 : at * std::sin(angle));
      freedoms.push_back({k == around ? -1 : next++, 1.0});
      freedoms.push_back({k == 0 ? -1 : next++, 1.0});
    }
  for (int k = 0; k < around; ++k)
    for (int i = 0; i < radial; ++i) {
      const int corner = k * (radial + 1) + i;
      mesh.elements.push_back({corner, corner + 1, corner + radial + 2, corner + radial + 1});
    }
  Body body(mesh, material, freedoms);
  Newton newton(body);
  // Forces of a unit pressure: by the work of a displacement along the normal of each inner edge.
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(body.size());
  for (int k = 0; k < around; ++k) {
    const int nodes[2] = {k * (radial + 1), (k + 1) * (radial + 1)};
    const Eigen::Vector2d p = mesh.nodes[static_cast<std::size_t>(nodes[0])],
                          q = mesh.nodes[static_cast<std::size_t>(nodes[1])];
    const Eigen::Vector2d normal(q[1] - p[1], p[0] - q[0]);
    for (int end = 0; end < 2; ++end) {
      const double r = end == 0 ? (2.0 * p[0] + q[0]) / 6.0 : (p[0] + 2.0 * q[0]) / 6.0;
      for (int along = 0; along < 2; ++along)
        if (const int of = body.freedom(nodes[end], along).unknown; of >= 0)
          unit[of] += 2.0 * std::numbers::pi * r * normal[along];
    }
  }
  const double pressure = 2.0 * strength * (std::log(c / a) + (1.0 - c * c * c / (b * b * b)) / 3.0);
  const std::vector<char> held(static_cast<std::size_t>(body.size()), 0);
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(body.size()), last = unknowns;
  double work = 0.0;
  constexpr int steps = 20;
  for (int step = 1; step <= steps; ++step) {
    solve(body, newton, unknowns, held, unknowns, unit * (pressure * step / steps));
    work += pressure * (step - 0.5) / steps * unit.dot(unknowns - last);
    last = unknowns;
  }
  const double expected = strength * (1.0 - poisson) * c * c * c / (b * b);
  EXPECT_NEAR(body.displacement(unknowns, radial, 0) / expected, 1.0, 0.005) << poisson;
  // How far it is plastic, to an element.
  double reached = 0.0;
  for (int element = 0; element < radial * around; ++element)
    for (int point = 0; point < 4; ++point)
      if (body.slip(element, point) > 0.0) reached = std::max(reached, body.place(element, point).norm());
  EXPECT_NEAR(reached, c, 1.0 / radial) << poisson;
  const Energies energies = body.energies();
  EXPECT_NEAR((energies.stored + energies.dissipated) / work, 1.0, 0.003) << poisson;
}

TEST(YieldBody, FollowsHillsSphere) {
  check_thick_sphere(0.3);
  check_thick_sphere(0.499);
}

/// The stress of Boussinesq is in equilibrium: through any plane below goes the whole load.
TEST(YieldHalfSpace, HasAPointLoadInEquilibrium) {
  const Material material{1.0, 0.3, never};
  double through = 0.0;
  constexpr int steps = 200000;
  for (int k = 0; k < steps; ++k) {
    const double r = 400.0 * (k + 0.5) / steps;
    through -= 2.0 * std::numbers::pi * r * point_load_stress(material, r, -1.0)[1] * 400.0 / steps;
  }
  EXPECT_NEAR(through, 1.0, 1e-5);
  // The energy outside falls as 1/size.
  EXPECT_NEAR(point_load_energy(material, 1.0) / point_load_energy(material, 3.0), 3.0, 1e-6);
}

struct Pushed {
  Reading reading;
  double work, imbalance, pressure;  ///< the last is the mean of the element at the middle
};

Pushed push(double poisson, double strength, double depth, int elements, double size) {
  const Material material{1.0 - poisson * poisson, poisson, strength};
  const double radius = std::sqrt(depth), element = radius / elements;
  Indentation indentation(half_space(material, {1.25 * radius, element, 1.0 + 3.6 / elements, size * radius}), 1.0);
  Pushed pushed{};
  Reading last{};
  constexpr int steps = 40;
  for (int k = 1; k <= steps; ++k) {
    pushed.reading = indentation.go(depth * k * k / (steps * steps));
    pushed.work += 0.5 * (pushed.reading.force + last.force) * (pushed.reading.depth - last.depth);
    last = pushed.reading;
  }
  const Energies energies = indentation.energies();
  for (int point = 0; point < 4; ++point) pushed.pressure -= 0.25 * indentation.body().stress(0, point)[1];
  pushed.imbalance = (energies.stored + energies.dissipated) / pushed.work - 1.0;
  return pushed;
}

/// F = (4/3) E* √R δ^{3/2}, a² = Rδ, W = (2/5) F δ, p₀ = 2 E* a/πR.
TEST(YieldIndentation, IsHertzianWithoutYield_long) {
  for (const double poisson : {0.2, 0.3, 0.45}) {
    const Pushed pushed = push(poisson, never, 1.0, 20, 40.0);
    EXPECT_NEAR(pushed.reading.force, 4.0 / 3.0, 0.004 * 4.0 / 3.0) << poisson;
    EXPECT_NEAR(pushed.reading.radius, 1.0, 0.01) << poisson;
    EXPECT_NEAR(pushed.pressure, 2.0 / std::numbers::pi, 0.01 * 2.0 / std::numbers::pi) << poisson;
    EXPECT_NEAR(pushed.work, 0.4 * 4.0 / 3.0, 0.004 * 0.4 * 4.0 / 3.0) << poisson;
  }
}

/// The far field is joined to a point load, so that the size of the domain hardly matters.
TEST(YieldIndentation, DoesNotDependOnItsDomain_long) {
  const double small = push(0.3, never, 1.0, 16, 6.0).reading.force,
               large = push(0.3, never, 1.0, 16, 40.0).reading.force;
  EXPECT_NEAR(small / large, 1.0, 2e-3);
}

TEST(YieldIndentation, BeginsToYieldAtTheOnset_long) {
  EXPECT_NEAR(onset_pressure(0.3), 1.613, 5e-4);
  EXPECT_NEAR(onset_pressure(0.5), 1.88, 0.01);
  const double strength = 2.0 / std::numbers::pi / onset_pressure(0.3);
  const Pushed before = push(0.3, strength, 0.97, 20, 20.0), after = push(0.3, strength, 2.0, 20, 20.0);
  EXPECT_NEAR(before.reading.force / (4.0 / 3.0 * std::pow(0.97, 1.5)), 1.0, 0.004);
  EXPECT_LT(after.reading.force, 0.99 * 4.0 / 3.0 * std::pow(2.0, 1.5));
  EXPECT_NEAR(after.imbalance, 0.0, 1e-3);
}

}  // namespace
