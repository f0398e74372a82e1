// Converged results of two bodies: limits, and answers of other methods.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/restitution.hpp"
#include "support/csv.hpp"
#include "support/refusal.hpp"
#include "support/rods_at_rest.hpp"

namespace stoss {
namespace {

// Large, stiff and heavy: a disk of the same size would stay round, however stiff.
TEST(Pairs, TendToTheRigidWall) {
  const double wall = restitution(disk(0.33), 0.1).lost_fraction.value;
  double last = 1.0;
  for (const double ratio : {10.0, 100.0, 1000.0}) {
    const Disk second{0.33, ratio, ratio * ratio / 10.0, 1.0};
    if (second.young > 1000.0) break;
    const double away =
        std::abs(restitution(RefinableContact(disk(0.33), disk(second)), 0.1).lost_fraction.value - wall);
    EXPECT_LT(away, 0.2 * last);
    last = away;
  }
  EXPECT_LT(last, 2e-2 * wall);
}

// Independent finite elements (tests/data/pair_restitution.csv).
TEST(Pairs, AgreeWithFiniteElements) {
  for (const auto& row : test::read_csv("pair_restitution.csv")) {
    const Disk second{row.number("poisson2"), row.number("radius2"), row.number("young2"), row.number("density2")};
    const Restitution found =
        restitution(RefinableContact(disk(0.33), disk(second)), row.number("speed"), {.tolerance = 2e-4});
    EXPECT_NEAR(found.lost_fraction.value, row.number("lost_fraction"),
                found.lost_fraction.error + row.number("uncertainty"));
    EXPECT_NEAR(found.contact_time.value / row.number("contact_time"), 1.0, 5e-3);
    EXPECT_NEAR(found.max_compression.value / row.number("max_compression"), 1.0, 1e-3);
  }
}

struct RodCase {
  double z1, t1, z2, t2, restitution;
};

void PrintTo(const RodCase& its, std::ostream* out) {
  *out << "impedances " << its.z1 << " and " << its.z2 << ", transit times " << its.t1 << " and " << its.t2;
}

class Rods : public ::testing::TestWithParam<RodCase> {};

TEST_P(Rods, TendToTheExactAnswer) {
  const auto [z1, t1, z2, t2, known] = GetParam();
  // E = ρ = 1: transit time = length, impedance = area.
  const Rod left{t1, 1.0, 1.0, z1}, right{t2, 1.0, 1.0, z2};
  EXPECT_NEAR(test::restitution_at_rest(left, right), known, 1e-5);
  const BodyMaker one = rod(left), other = rod(right);
  double last = 1.0;
  for (const double cutoff : {100.0, 400.0, 1600.0}) {
    const double unit = std::max(1.0, t1 / t2);  // in the shorter rod
    const double away = std::abs(impact(contact(one, other, cutoff * unit), 0.1).restitution - known);
    EXPECT_LT(away, 0.5 * last + 1e-4) << cutoff;
    last = away;
  }
  EXPECT_LT(last, 1e-3);
  if (known == 1.0) return;  // no loss, no relative error of it
  const Restitution found = restitution(RefinableContact(one, other), 0.1, {.tolerance = 0.03});
  EXPECT_NEAR(found.restitution.value, known, found.restitution.error);
  EXPECT_NEAR(found.max_force.value, 0.1 * z2 / (z1 + z2), found.max_force.error);  // of the first contact, in EA
  EXPECT_LT(found.max_force.error, 0.25 * found.max_force.value);
}

INSTANTIATE_TEST_SUITE_P(Exact, Rods,
                         ::testing::Values(RodCase{3, 10, 1, 25, 0.7875}, RodCase{1, 10, 3, 20, 0.75},
                                           RodCase{2, 30, 5, 11, 0.710929}, RodCase{1, 1, 1, 3, 1.0 / 3.0},
                                           RodCase{1, 1, 1, 1, 1.0}));
INSTANTIATE_TEST_SUITE_P(Exact_long, Rods, ::testing::Values(RodCase{5, 10, 1, 73, 0.596178}));

TEST(Pairs, RefuseWhatDoesNotMeet) {
  test::expect_refusal([] { (void)contact(disk(0.33), rod(), 25.0); }, {"against", "rod", "disk"});
  test::expect_refusal([] { (void)contact(disk(0.33), disk(Disk{0.33, 2e3, 1.0, 1.0}), 25.0); }, {"radius", "1000"});
  test::expect_refusal([] { (void)contact(disk(0.33), disk(Disk{0.33, 1.0, 1e-7, 1.0}), 25.0); }, {"young", "1e-6"});
  test::expect_refusal([] { (void)contact(disk(0.33), disk(Disk{0.33, 1.0, 1.0, 2e3}), 25.0); }, {"density", "1000"});
  test::expect_refusal([] { (void)contact(disk(0.33, 25.0), disk(0.33, 30.0)); }, {"cutoff", "25", "30"});
}

}  // namespace
}  // namespace stoss
