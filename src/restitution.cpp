#include "stoss/restitution.hpp"

#include <cmath>
#include <utility>

namespace stoss {

RefinedBody refine(const BodyMaker& maker) { return {maker(25.0), maker(50.0)}; }

Restitution restitution(const RefinedBody& body, double speed) {
  const Impact coarse = impact(body.coarse, HardWall{}, speed);
  Impact fine = impact(body.fine, HardWall{}, speed);
  Restitution result;
  result.value = fine.restitution;
  result.error = std::abs(fine.restitution - coarse.restitution);
  result.lost_fraction = fine.lost_fraction;
  result.lost_fraction_error = std::abs(fine.lost_fraction - coarse.lost_fraction);
  result.steps = coarse.steps + fine.steps;
  result.finest = std::move(fine);
  return result;
}

Restitution restitution(const BodyMaker& maker, double speed) { return restitution(refine(maker), speed); }

}  // namespace stoss
