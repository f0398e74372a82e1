#pragma once

#include <memory>
#include <vector>

#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies {

/// Which of two blocks of displacements at points on both sides of the axis, and of the forces that drive them.
enum class Parity {
  normal_even,  ///< (x even | y odd)
  along_even    ///< (y even | x odd)
};

/// The body as it answers forces of each of these parities.
/// @param groups   the modes of a parity
/// @param surface  a parity at points
/// @param residual answers for what is not kept, of a parity between points
template <typename Groups, typename Surface, typename Residual>
[[nodiscard]] std::vector<Body> of_parities(const std::vector<Parity>& parities, const Body& body, const Groups& groups,
                                            const Surface& surface, std::shared_ptr<const Residual> residual) {
  std::vector<Body> bodies;
  for (const Parity parity : parities) {
    Body& its = bodies.emplace_back(body);
    its.components = 2;
    its.groups = groups(parity);
    its.surface = [surface, parity](const ContactPoints& points) { return surface(parity, points); };
    its.residual_compliance = [residual, parity](const ContactPoints& points, const Poll& poll) {
      return residual->compliance(parity, points, poll);
    };
    its.residual_second_moment = [residual, parity](const ContactPoints& points, const Poll& poll) {
      return residual->second_moment(parity, points, poll);
    };
  }
  return bodies;
}

}  // namespace stoss::bodies
