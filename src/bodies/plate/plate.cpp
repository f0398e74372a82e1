#include "stoss/bodies/plate.hpp"

#include "stoss/bodies/half_space.hpp"

namespace stoss {

Body plate(const Plate& plate, double cutoff, double duration, const Poll& poll) {
  return half_space({plate.poisson, plate.young, plate.density, plate.loss_time}, cutoff, duration, poll);
}

Body strip(const Strip& strip, double cutoff, double duration, const Poll& poll) {
  return half_plane({strip.poisson, strip.young, strip.density, strip.loss_time}, cutoff, duration, poll);
}

BodyMaker plate(const Plate& plate) {
  return half_space(HalfSpace{plate.poisson, plate.young, plate.density, plate.loss_time});
}

BodyMaker strip(const Strip& strip) {
  return half_plane(HalfPlane{strip.poisson, strip.young, strip.density, strip.loss_time});
}

}  // namespace stoss
