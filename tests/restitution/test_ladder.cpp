// The cutoffs at which a contact can be made.
#include "stoss/restitution/ladder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

const double lowest = 4.0 * std::sqrt(2.0);

/// A disk whose near side is not known.
BodyMaker only_whole(double poisson, double radius) {
  return [maker = disk(Disk{poisson, radius, 1.0, 1.0})](double cutoff, const Poll& poll) {
    Body body = maker(cutoff, poll);
    body.near_side = nullptr;
    return body;
  };
}

TEST(Ladder, AtAWallRisesByFourthRootsOfTwo) {
  const RefinableContact wall(disk(0.33));
  EXPECT_EQ(wall.highest_level(), 24);
  EXPECT_NEAR(wall.cutoff(0), lowest, 1e-14);
  EXPECT_NEAR(wall.cutoff(6), 16.0, 1e-13);
  EXPECT_NEAR(wall.cutoff(24), 362.0, 0.1);
}

TEST(Ladder, MakesEachContactOnceAndSharesIt) {
  const RefinableContact pair(disk(0.33), disk(Disk{0.2, 0.5, 2.0, 3.0}));
  const RefinableContact copy = pair;
  const Contact& made = pair.at(2);
  EXPECT_EQ(&copy.at(2), &made);
  EXPECT_NE(&pair.at(1), &made);
  EXPECT_EQ(made.cutoff, pair.cutoff(2));
  EXPECT_NE(made.second, nullptr);
  EXPECT_EQ(RefinableContact(disk(0.33)).at(0).second, nullptr);
}

TEST(Ladder, OfAPairIsOneLadderOfFrequenciesWhoeverIsFirst) {
  const Disk one{0.33}, other{0.2, 2.0, 0.5, 3.0};
  const double time = 2.0 / std::sqrt(0.5 / 3.0);  // R/c of the other
  const RefinableContact here(disk(one), disk(other)), there(disk(other), disk(one));
  EXPECT_EQ(there.highest_level(), here.highest_level());
  EXPECT_NEAR(there.cutoff(5) / time, here.cutoff(5), 1e-12);
  EXPECT_NEAR(here.cutoff(0), lowest / time_scale(here.at(0)), 1e-13);
  EXPECT_EQ(RefinableContact(disk(one), disk(one)).highest_level(), 24);
}

TEST(Ladder, EndsWhereTheLargerBodyHasMoreModesThanAreComputed) {
  for (const double radius : {5.0, 20.0, 40.0}) {
    const RefinableContact pair(disk(0.33), disk(Disk{0.33, radius, 1.0, 1.0}));
    EXPECT_EQ(pair.part(), 1.0);
    const int highest = pair.highest_level();
    EXPECT_LT(highest, 24) << radius;
    EXPECT_GE(highest, 9) << radius;
    EXPECT_LE(pair.cutoff(highest) * radius, 1000.0) << radius;
    EXPECT_GT(pair.cutoff(highest + 1) * radius, 1000.0) << radius;
  }
}

TEST(Ladder, OfMuchLargerOrSlowerDisksTakesTheirNearSide) {
  for (const Disk& second : {Disk{0.33, 46.0, 1.0, 1.0}, Disk{0.33, 1000.0, 1.0, 1.0}, Disk{0.33, 1000.0, 1e-3, 1e3}}) {
    const RefinableContact pair(disk(0.33), disk(second)), swapped(disk(second), disk(0.33));
    EXPECT_LT(pair.part(), 0.5) << second.radius;
    EXPECT_NEAR(swapped.part() / pair.part(), 1.0, 1e-12);
    EXPECT_EQ(swapped.highest_level(), pair.highest_level());
    EXPECT_EQ(pair.at(0).second->part.size, pair.part());
    EXPECT_EQ(swapped.at(0).first->part.size, swapped.part());
    EXPECT_EQ(pair.at(0).first->part.size, 1.0);
  }
}

TEST(Ladder, OfRodsIsInTheShorterTransitTime) {
  EXPECT_NEAR(RefinableContact(rod(), rod(Rod{4.0, 1.0, 1.0, 1.0})).cutoff(0), lowest, 1e-13);
  EXPECT_NEAR(RefinableContact(rod(), rod(Rod{0.25, 1.0, 1.0, 1.0})).cutoff(0), 4.0 * lowest, 1e-12);
}

TEST(Ladder, RefusesLevelsThatItDoesNotHave) {
  const RefinableContact pair(disk(0.33), disk(Disk{0.33, 20.0, 1.0, 1.0}));
  test::expect_refusal([&] { (void)pair.at(-1); }, {"level", "-1"});
  test::expect_refusal([&] { (void)pair.at(pair.highest_level() + 1); }, {"level"});
}

TEST(Ladder, RefusesBodiesThatItCannotRefine) {
  test::expect_refusal([] { RefinableContact none{BodyMaker{}}; }, {"body"});
  test::expect_refusal([] { RefinableContact none(disk(0.33), BodyMaker{}); }, {"against"});
  test::expect_refusal([] { RefinableContact none(disk(0.33), rod()); }, {"against", "rod", "disk"});
  test::expect_refusal([] { RefinableContact none(only_whole(0.33, 1.0), only_whole(0.33, 60.0)); },
                       {"against: got 'disk' of 60 times the R/c of 'disk'", "at most 52 times"});
  EXPECT_NO_THROW(RefinableContact(only_whole(0.33, 1.0), only_whole(0.33, 52.0)));
  test::expect_refusal([] { RefinableContact none(only_whole(0.33, 1.0), only_whole(0.33, 53.0)); }, {"52 times"});
}

TEST(Ladder, ImpactsAtAnAngleNeedWholeBodies) {
  EXPECT_GE(RefinableContact(disk(0.33), disk({.poisson = 0.33, .radius = 170.0})).highest_whole_level(), 2);
  const RefinableContact unequal(disk(0.33), disk({.poisson = 0.33, .radius = 300.0}));
  test::expect_refusal([&] { (void)unequal.highest_whole_level(); },
                       {"against: got 'disk' of 300 times the R/c of 'disk'", "at an angle", "176 times"});
}

}  // namespace
}  // namespace stoss
