// What a slow lossy disk loses to its material: the whole computation against the law of the first order.
#include <gtest/gtest.h>

#include "stoss/bodies/disk.hpp"
#include "stoss/quasistatic/slow_impact.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {
namespace {

TEST(RestitutionOfLossyDisks, TendsToTheLawOfSlowImpacts) {
  // In addition to the viscous loss of the law, damping changes the vibration left in the disk by some per cent of it.
  constexpr double of_vibration = 0.04;
  const RefinableContact elastic(disk(0.33));
  for (const double loss_time : {1e-3, 1e-2}) {
    const RefinableContact lossy(disk(Disk{.poisson = 0.33, .loss_time = loss_time}));
    for (const double speed : {1e-8, 1e-7, 1e-6}) {
      const Restitution with = restitution(lossy, speed, {.tolerance = 3e-4}), without = restitution(elastic, speed);
      const double law = quasistatic::viscous_loss(quasistatic::CompressionLaw::center, 0.33, loss_time, speed);
      EXPECT_NEAR((without.restitution.value - with.restitution.value) / law, 1.0, of_vibration)
          << loss_time << ", " << speed;
    }
  }
}

}  // namespace
}  // namespace stoss
