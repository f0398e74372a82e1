// The bench's finite elements, a rival of stoss: their meshes, their stiffness by exact modes, and what the bench says
// that they reach.
#include "bench/finite_elements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bench/element_collision.hpp"
#include "bench/finite_element_cases.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/sphere/modes.hpp"

namespace bench {
namespace {

FiniteElements disk(double of_poisson, const MeshSize& size) {
  return FiniteElements(Symmetry::plane, of_poisson, half_disk(Symmetry::plane, size));
}

FiniteElements ball(double of_poisson, const MeshSize& size) {
  return FiniteElements(Symmetry::axial, of_poisson, half_disk(Symmetry::axial, size));
}

double radius_of(const Point& point) { return std::min(1.0, std::hypot(point.across, point.towards)); }

/// Of components along the radius and the angle from the normal of the wall.
Point from_polar(double radial, double tangential, double angle) {
  return {radial * std::sin(angle) + tangential * std::cos(angle),
          radial * std::cos(angle) - tangential * std::sin(angle)};
}

/// The displacement of a mode at a node, by its amplitudes there.
Point of_disk(int order, const stoss::bodies::Displacement& polar, double angle) {
  return from_polar(polar.radial * std::cos(order * angle), polar.tangential * std::sin(order * angle), angle);
}

Point of_sphere(int order, const stoss::bodies::Displacement& polar, double angle) {
  const auto degree = static_cast<unsigned>(order);
  return from_polar(polar.radial * std::legendre(degree, std::cos(angle)),
                    -polar.tangential * std::assoc_legendre(degree, 1, std::cos(angle)), angle);
}

/// The largest relative error of ω² by the exact displacements of modes, of all with shear waves of a length of at
/// least π/4.
template <typename Displacements, typename At>
double error_of_frequencies(FiniteElements elements, double of_poisson, const std::vector<stoss::bodies::Mode>& modes,
                            const Displacements& displacements, const At& at) {
  std::vector<double> radii;
  for (const Point& node : elements.nodes()) radii.push_back(radius_of(node));
  double largest = 0.0;
  for (const auto& mode : modes) {
    const std::vector<stoss::bodies::Displacement> polar = displacements(of_poisson, mode, radii);
    std::vector<Point> moved;
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const Point& node = elements.nodes()[i];
      moved.push_back(at(mode.order, polar[i], std::atan2(node.across, node.towards)));
    }
    largest = std::max(largest, std::abs(elements.rayleigh_quotient(moved) / (mode.omega * mode.omega) - 1.0));
  }
  return largest;
}

double cutoff(double of_poisson) { return 8.0 / std::sqrt(2.0 * (1.0 + of_poisson)); }

double error_of_disk(double of_poisson, const MeshSize& size) {
  namespace disk_modes = stoss::bodies::disk;
  return error_of_frequencies(
      disk(of_poisson, size), of_poisson, disk_modes::modes(of_poisson, cutoff(of_poisson)),
      [](auto... of) { return disk_modes::displacement(of...); }, of_disk);
}

double error_of_ball(double of_poisson, const MeshSize& size) {
  namespace sphere_modes = stoss::bodies::sphere;
  return error_of_frequencies(
      ball(of_poisson, size), of_poisson, sphere_modes::modes(of_poisson, cutoff(of_poisson)),
      [](auto... of) { return sphere_modes::displacement(of...); }, of_sphere);
}

class DiskElements : public ::testing::TestWithParam<double> {};

TEST_P(DiskElements, FrequenciesAreThoseOfTheModes) {
  const double fine = error_of_disk(GetParam(), {12, 9, 0.3});
  EXPECT_LT(fine, 1e-7);
  EXPECT_LT(fine, error_of_disk(GetParam(), {4, 3, 0.3}) / 729.0);  // at least of sixth order
}

INSTANTIATE_TEST_SUITE_P(Poisson, DiskElements, ::testing::Values(-0.4, 0.0, 0.33, 0.9));

class BallElements : public ::testing::TestWithParam<double> {};

TEST_P(BallElements, FrequenciesAreThoseOfTheModes) {
  const double fine = error_of_ball(GetParam(), {12, 9, 0.3});
  EXPECT_LT(fine, 1e-7);
  EXPECT_LT(fine, error_of_ball(GetParam(), {4, 3, 0.3}) / 729.0);
}

INSTANTIATE_TEST_SUITE_P(Poisson, BallElements, ::testing::Values(-0.4, 0.0, 0.3, 0.45));

TEST(FiniteElements, FillTheirBody) {
  EXPECT_NEAR(disk(poisson, {4, 3, 0.3}).mass(), 0.5 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(ball(poisson_of_sphere, {4, 3, 0.3}).mass(), 2.0 / 3.0, 1e-9);
}

/// Whether a mesh, and others graded a little less and more, reach the tolerance: no crossing of the true value by
/// chance.
template <typename Case, typename LostFraction>
void expect_within_tolerance(const Case& task, const LostFraction& lost_fraction) {
  for (const double change : {-0.05, 0.0, 0.05}) {
    MeshSize mesh = task.mesh;
    mesh.grading += change;
    EXPECT_NEAR(lost_fraction(mesh) / task.at.lost_fraction, 1.0, task.tolerance)
        << "v = " << task.at.speed << ", grading " << mesh.grading;
  }
}

TEST(FiniteElements, OfADiskReachTheTolerancesOfTheBench) {
  for (const ElementCase& task : disk_element_cases) {
    expect_within_tolerance(task, [&task](const MeshSize& mesh) {
      FiniteElements body = disk(poisson, mesh);
      return collide(body, task.at.speed).lost_fraction;
    });
  }
}

TEST(FiniteElements, OfABallReachTheTolerancesOfTheBench_long) {
  for (const ElementCase& task : sphere_element_cases) {
    expect_within_tolerance(task, [&task](const MeshSize& mesh) {
      FiniteElements body = ball(poisson_of_sphere, mesh);
      return collide(body, task.at.speed).lost_fraction;
    });
  }
}

double on_half_space(const MeshSize& mesh, const BlockSize& size, double at) {
  FiniteElements body = ball(poisson_of_sphere, mesh);
  FiniteElements below(Symmetry::axial, poisson_of_sphere, block(mesh, size));
  return collide(body, below, at).lost_fraction;
}

TEST(FiniteElements, OfABallOnAHalfSpaceReachTheTolerancesOfTheBench_long) {
  for (const BlockElementCase& task : block_element_cases) {
    expect_within_tolerance(task,
                            [&task](const MeshSize& mesh) { return on_half_space(mesh, task.block, task.at.speed); });
  }
}

/// Waves that its faces send back would come to the contact too late.
TEST(FiniteElements, ABlockIsAsGoodAsALargerOne_long) {
  for (const BlockElementCase& task : block_element_cases) {
    BlockSize larger = task.block;
    larger.extent *= 1.5;
    const double change =
        on_half_space(task.mesh, larger, task.at.speed) / on_half_space(task.mesh, task.block, task.at.speed) - 1.0;
    EXPECT_LT(std::abs(change), 0.1 * task.tolerance) << "v = " << task.at.speed;
  }
}

/// On average over gradings, as errors of single meshes change their sign.
template <typename LostFraction>
void expect_convergence(double converged, const LostFraction& lost_fraction) {
  const auto error = [&](int elements, int rings) {
    const std::vector<double> gradings = {0.2, 0.25, 0.3, 0.35};
    double sum = 0.0;
    for (const double grading : gradings) {
      sum += std::abs(lost_fraction(MeshSize{elements, rings, grading}) / converged - 1.0);
    }
    return sum / static_cast<double>(gradings.size());
  };
  EXPECT_LT(error(8, 4), error(2, 1) / 4.0);
}

TEST(FiniteElements, ConvergeUnderRefinement_long) {
  expect_convergence(converged_lost_fraction, [](const MeshSize& mesh) {
    FiniteElements body = disk(poisson, mesh);
    return collide(body, speed).lost_fraction;
  });
  expect_convergence(sphere_cases[0].lost_fraction, [](const MeshSize& mesh) {
    FiniteElements body = ball(poisson_of_sphere, mesh);
    return collide(body, sphere_cases[0].speed).lost_fraction;
  });
  expect_convergence(half_space_cases[0].lost_fraction, [](const MeshSize& mesh) {
    return on_half_space(mesh, {0.55, 5.5}, half_space_cases[0].speed);
  });
}

}  // namespace
}  // namespace bench
