#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "check.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies {

/// Name of a disk or a sphere with what is not 1 of its size and material.
template <typename Round>
[[nodiscard]] std::string name_of(const std::string& kind, const Round& round) {
  std::string name = kind + " poisson=" + shown(round.poisson);
  if (round.radius != 1.0) name += " radius=" + shown(round.radius);
  if (round.young != 1.0) name += " young=" + shown(round.young);
  if (round.density != 1.0) name += " density=" + shown(round.density);
  if (round.loss_time != 0.0) name += " loss_time=" + shown(round.loss_time);
  return name;
}

/// c of its material.
template <typename Round>
[[nodiscard]] double wave_speed(const Round& round) {
  return std::sqrt(round.young / round.density);
}

/// η in R/c of the body.
template <typename Round>
[[nodiscard]] double own_loss_time(const Round& round) {
  return in_own_time(round.loss_time, wave_speed(round) / round.radius);
}

/// Checks all but the Poisson's ratio. @throws InvalidInput
template <typename Round>
void require_size_and_material(const std::string& kind, const Round& round) {
  constexpr Range positive{0.0, std::numeric_limits<double>::max(), false, true, "a positive finite number"};
  require("radius", round.radius, positive, "of the " + kind);
  require("young", round.young, positive, "Young's modulus of the " + kind);
  require("density", round.density, positive, "of the " + kind);
  require_loss_time(own_loss_time(round));
}

/// Lets the modes that are not kept answer for the body.
template <typename Residual>
void set_residual(Body& body, std::shared_ptr<const Residual> residual) {
  body.stable_step = residual->stable_step();
  body.residual_compliance = [residual](const ContactPoints& points, const Poll& poll) {
    return residual->compliance(points, poll);
  };
  body.residual_second_moment = [residual](const ContactPoints& points, const Poll& poll) {
    return residual->second_moment(points, poll);
  };
  body.opposite_compliance = [residual](const ContactPoints& here, const ContactPoints& there) {
    return residual->opposite_compliance(here, there);
  };
}

}  // namespace stoss::bodies
