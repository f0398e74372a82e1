#include "stoss/bodies/plate.hpp"

#include <cmath>
#include <limits>

#include "check.hpp"
#include "stoss/bodies/half_space.hpp"

namespace stoss {
namespace {

void require_thickness(double thickness) {
  constexpr Range positive{0.0, std::numeric_limits<double>::max(), false, true, "a positive finite number"};
  require("thickness", thickness, positive, "of the plate, from face to face");
}

}  // namespace

Body plate(const Plate& plate, double cutoff, double duration, const Poll& poll) {
  return half_space({plate.poisson, plate.young, plate.density, plate.loss_time}, cutoff, duration, poll);
}

Body strip(const Strip& strip, double cutoff, double duration, const Poll& poll) {
  return half_plane({strip.poisson, strip.young, strip.density, strip.loss_time}, cutoff, duration, poll);
}

BodyMaker plate(const Plate& plate) {
  require_thickness(plate.thickness);
  for (const Layer& each : plate.below) {
    if (std::isfinite(each.thickness)) require_thickness(each.thickness);
    (void)half_space(HalfSpace{each.poisson, each.young, each.density});
  }
  return half_space(HalfSpace{plate.poisson, plate.young, plate.density, plate.loss_time});
}

BodyMaker strip(const Strip& strip) {
  require_thickness(strip.thickness);
  return half_plane(HalfPlane{strip.poisson, strip.young, strip.density, strip.loss_time});
}

}  // namespace stoss
