// Plates of layers: one material in pieces is the same plate, and modes of different ones are those of elements through
// the depth.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "bodies/plate/branches.hpp"
#include "support/plate_elements.hpp"
#include "support/plate_materials.hpp"

namespace stoss {
namespace plate_layers {
namespace {

using namespace bodies::plate;

/// Modes and others at a frequency iω: Σ φφᵀ/(ω_m² + ω²) of modes, and what the others add to slow forces.
Eigen::Matrix2d answer(const Branches<2>& its, double omega) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (std::size_t m = 0; m < its.omega.size(); ++m) {
    sum += its.amplitude[m] * its.amplitude[m].transpose() / (its.omega[m] * its.omega[m] + omega * omega);
  }
  return sum;
}

constexpr double wave_numbers[] = {0.02, 0.2, 1.0, 3.0, 9.0, 30.0};

TEST(PlateInPieces, IsThePlate) {
  for (const test::Slab& its : {test::Slab{0.3}, test::Slab{0.45}, test::Slab{-0.5, true}}) {
    const Sheet whole = its.sheet();
    for (const std::vector<double>& shares :
         {std::vector{0.5, 0.5}, {0.1, 0.9}, {0.2, 0.5, 0.3}, {0.2, 0.2, 0.2, 0.2, 0.2}, {0.01, 0.4, 0.3, 0.19, 0.1}}) {
      Sheets pieces;
      for (const double share : shares) {
        pieces.all.push_back(whole);
        pieces.all.back().thickness *= share;
      }
      const Sheets plate{{whole}};
      for (const double k : wave_numbers) {
        SCOPED_TRACE(std::to_string(shares.size()) + " pieces, k = " + std::to_string(k));
        const double cutoff = its.shear_speed() * (1.03 * k + 10.3 / its.thickness);
        const Branches<2> one = branches<2>(plate, k, cutoff, {}), other = branches<2>(pieces, k, cutoff, {});
        ASSERT_EQ(count_below<2>(plate, k, cutoff), count_below<2>(pieces, k, cutoff));
        ASSERT_EQ(one.omega.size(), other.omega.size());
        for (std::size_t m = 0; m < one.omega.size(); ++m) EXPECT_NEAR(other.omega[m] / one.omega[m], 1.0, 1e-8) << m;
        const double slow = static_compliance<2>(plate, k).norm();
        EXPECT_LT((static_compliance<2>(pieces, k) - static_compliance<2>(plate, k)).norm(), 1e-10 * slow);
        // Waves on both faces of a thick plate hardly differ, and are found as one in pieces.
        const double error = k * its.thickness > 20.0 ? 1e-7 : 1e-9;
        EXPECT_LT((other.compliance - one.compliance).norm(), error * one.compliance.norm());
        const Eigen::Matrix2d kept = answer(one, cutoff);
        EXPECT_LT((answer(other, cutoff) - kept).norm(), error * kept.norm());
        const Branches<1> across = branches<1>(plate, k, cutoff, {}), in_pieces = branches<1>(pieces, k, cutoff, {});
        ASSERT_EQ(across.omega.size(), in_pieces.omega.size());
        for (std::size_t m = 0; m < across.omega.size(); ++m) {
          EXPECT_NEAR(in_pieces.omega[m] / across.omega[m], 1.0, 1e-11);
          EXPECT_NEAR(in_pieces.amplitude[m](0) / across.amplitude[m](0), 1.0, 1e-8) << m;
        }
      }
    }
  }
}

/// Layers from the top down: thickness, Young's modulus, Poisson's ratio, density.
struct Stack {
  std::string name;
  std::vector<std::vector<double>> layers;
};

void PrintTo(const Stack& stack, std::ostream* out) { *out << stack.name; }

const std::vector<Stack> stacks{
    {"laminated_glass", {{0.8, 1.0, 0.23, 1.0}, {0.2, 0.01, 0.45, 0.43}, {0.8, 1.0, 0.23, 1.0}}},
    {"stiff_coating", {{0.1, 3.0, 0.25, 1.9}, {1.0, 1.0, 0.3, 1.0}}},
    {"soft_coating", {{0.2, 0.1, 0.4, 0.4}, {1.0, 1.0, 0.3, 1.0}}},
    {"unsymmetric", {{0.3, 1.0, 0.3, 1.0}, {0.5, 0.3, -0.4, 2.0}, {0.1, 5.0, 0.1, 3.0}, {0.4, 0.7, 0.45, 0.8}}},
    {"coating_on_a_stiff_block", {{0.3, 1.0, 0.35, 1.0}, {3.0, 50.0, 0.2, 2.5}}},
    {"mirrored_pairs", {{0.2, 2.0, 0.2, 1.5}, {0.4, 1.0, 0.3, 1.0}, {0.4, 1.0, 0.3, 1.0}, {0.2, 2.0, 0.2, 1.5}}}};

class LayersAndElements : public testing::TestWithParam<Stack> {
 protected:
  std::vector<Sheet> sheets;
  double thickness = 0.0, speed = 0.0;

  void SetUp() override {
    for (const std::vector<double>& of : GetParam().layers) {
      const test::Slab slab{of[2], false, of[0], of[1], of[3]};
      sheets.push_back(slab.sheet());
      thickness += of[0], speed = std::max(speed, slab.shear_speed());
    }
  }
};

TEST_P(LayersAndElements, HaveTheSameModes) {
  const int elements = sheets.size() > 2 ? 3 : 5;
  for (const double kh : {0.05, 0.7, 3.0, 9.0}) {
    const double k = kh / thickness;
    SCOPED_TRACE("kh = " + std::to_string(kh));
    const test::PlateElements reference(sheets, k, elements);
    // Between two modes that are well apart.
    std::size_t kept = 9;
    while (reference.omega[kept] / reference.omega[kept - 1] < 1.02) ++kept;
    const double cutoff = 0.5 * (reference.omega[kept - 1] + reference.omega[kept]);
    const Branches<2> found = branches<2>(Sheets{sheets}, k, cutoff, {});
    ASSERT_EQ(found.omega.size(), kept);
    for (std::size_t m = 0; m < kept; ++m) {
      EXPECT_NEAR(found.omega[m] / reference.omega[m], 1.0, 1e-8 + reference.rounding(m)) << m;
      const Eigen::Matrix2d strength = found.amplitude[m] * found.amplitude[m].transpose();
      EXPECT_LT((strength - reference.strength(m)).norm(), 1e-8 / thickness) << m;
    }
    // The elements have as many modes as unknowns, which together are as soft as the elements.
    Eigen::Matrix2d rest = Eigen::Matrix2d::Zero();
    for (std::size_t m = kept; m < reference.omega.size(); ++m) {
      rest += reference.strength(m) / std::pow(reference.omega[m], 2);
    }
    EXPECT_LT((found.compliance - rest).norm(), 1e-8 * rest.norm());
    const Eigen::Matrix2d slow = reference.compliance();
    const double error = (1e-9 + reference.rounding(0)) * slow.norm();
    EXPECT_LT((static_compliance<2>(Sheets{sheets}, k) - slow).norm(), error);
    // What a body is told of both directions: motion towards −k goes with motion into the depth.
    const bodies::Flexibility all = plane_compliance(lamina(Contour::ball, sheets), k);
    const double weight = 0.5 * k / std::numbers::pi;
    EXPECT_NEAR(all.radial, weight * slow(1, 1), weight * error);
    EXPECT_NEAR(all.mixed, -weight * slow(0, 1), weight * error);
    EXPECT_NEAR(all.tangential, weight * slow(0, 0), weight * error);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, LayersAndElements, testing::ValuesIn(stacks),
                         [](const auto& its) { return its.param.name; });

}  // namespace
}  // namespace plate_layers
}  // namespace stoss
