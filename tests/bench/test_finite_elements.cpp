// The bench's finite elements, a rival of stoss: their mesh, their stiffness by exact modes, and what the bench says
// that they reach.
#include "bench/finite_elements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bench/finite_element_cases.hpp"
#include "stoss/bodies/disk/modes.hpp"

namespace bench {
namespace {

/// The displacement of a mode, symmetric about the normal of the wall, at the nodes.
std::vector<Point> displacement_of(double poisson, const stoss::bodies::disk::Mode& mode,
                                   const std::vector<Point>& nodes) {
  std::vector<double> radii;
  for (const Point& node : nodes) radii.push_back(std::min(1.0, std::hypot(node.across, node.towards)));
  const std::vector<stoss::bodies::disk::Displacement> polar = stoss::bodies::disk::displacement(poisson, mode, radii);
  std::vector<Point> result;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double angle = std::atan2(nodes[i].across, nodes[i].towards);
    const double radial = polar[i].radial * std::cos(mode.order * angle);
    const double tangential = polar[i].tangential * std::sin(mode.order * angle);
    result.push_back({radial * std::sin(angle) + tangential * std::cos(angle),
                      radial * std::cos(angle) - tangential * std::sin(angle)});
  }
  return result;
}

class ElementsOfPoisson : public ::testing::TestWithParam<double> {};

/// The largest relative error of ω² by the exact displacement of a mode, of all with shear
/// waves of a length of at least π/4.
double error_of_frequencies(double poisson, const MeshSize& size) {
  FiniteElements elements(poisson, size);
  const double cutoff = 8.0 / std::sqrt(2.0 * (1.0 + poisson));
  double largest = 0.0;
  for (const auto& mode : stoss::bodies::disk::modes(poisson, cutoff)) {
    const double square = elements.rayleigh_quotient(displacement_of(poisson, mode, elements.nodes()));
    largest = std::max(largest, std::abs(square / (mode.omega * mode.omega) - 1.0));
  }
  return largest;
}

TEST_P(ElementsOfPoisson, FrequenciesAreThoseOfTheModes) {
  const double fine = error_of_frequencies(GetParam(), {8, 6, 0.3});
  EXPECT_LT(fine, 1e-5);
  EXPECT_LT(fine, error_of_frequencies(GetParam(), {4, 3, 0.3}) / 64.0);  // at least of sixth order
}

INSTANTIATE_TEST_SUITE_P(Poisson, ElementsOfPoisson, ::testing::Values(-0.4, 0.0, 0.33, 0.9));

TEST(FiniteElements, FillHalfADisk) {
  EXPECT_NEAR(FiniteElements(poisson, {4, 3, 0.3}).mass(), 0.5 * std::numbers::pi, 1e-9);
}

/// And so do meshes that are graded a little less and more: no crossing of the true value by chance.
TEST(FiniteElements, ReachTheTolerancesOfTheBench) {
  for (const ElementCase& task : element_cases) {
    for (const double change : {-0.05, 0.0, 0.05}) {
      MeshSize mesh = task.mesh;
      mesh.grading += change;
      const double lost_fraction = FiniteElements(poisson, mesh).collide(task.at.speed).lost_fraction;
      EXPECT_NEAR(lost_fraction / task.at.lost_fraction, 1.0, task.tolerance)
          << "v = " << task.at.speed << ", grading " << mesh.grading;
    }
  }
}

/// On average over gradings, as errors of single meshes change their sign.
TEST(FiniteElements, ConvergeUnderRefinement) {
  const auto error = [](int elements, int rings) {
    const std::vector<double> gradings = {0.2, 0.25, 0.3, 0.35};
    double sum = 0.0;
    for (const double grading : gradings) {
      const double found = FiniteElements(poisson, {elements, rings, grading}).collide(speed).lost_fraction;
      sum += std::abs(found / converged_lost_fraction - 1.0);
    }
    return sum / static_cast<double>(gradings.size());
  };
  const double fine = error(8, 4);
  EXPECT_LT(fine, 1e-3);
  EXPECT_LT(fine, error(2, 1) / 4.0);
}

}  // namespace
}  // namespace bench
