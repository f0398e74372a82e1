#include "stoss/restitution.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stoss {

RefinedBody refine(const BodyMaker& maker) { return {maker(25.0), maker(50.0)}; }

Restitution restitution(const RefinedBody& body, double speed) {
  const Impact coarse = impact(body.coarse, HardWall{}, speed);
  Impact fine = impact(body.fine, HardWall{}, speed);
  Restitution result;
  result.value = fine.restitution;
  result.lost_fraction = fine.lost_fraction;
  // Two curves that cross agree by chance: what the energy ledger lacks is a floor under their difference.
  const double difference = std::abs(fine.lost_fraction - coarse.lost_fraction);
  result.lost_fraction_error = std::max(difference, std::abs(fine.energy_error));
  const double squared = fine.restitution * fine.restitution;
  result.error =
      result.lost_fraction_error / (std::sqrt(squared + result.lost_fraction_error) + std::abs(fine.restitution));
  result.steps = coarse.steps + fine.steps;
  result.finest = std::move(fine);
  return result;
}

Restitution restitution(const BodyMaker& maker, double speed) { return restitution(refine(maker), speed); }

}  // namespace stoss
