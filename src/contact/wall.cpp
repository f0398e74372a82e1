#include "stoss/contact/wall.hpp"

#include "check.hpp"
#include "contact/exponential_wall.hpp"
#include "contact/quasistatic_tail.hpp"
#include "contact/radiating_tail.hpp"

namespace stoss {

void validate(const Wall& wall) {
  const auto* soft = std::get_if<ExponentialWall>(&wall);
  if (soft == nullptr) return;
  require("hardness", soft->hardness, {1.0, 1e6, true, true, "1 to 1e6"},
          "alpha R of the exponential wall; 500 is usual");
  require("strength", soft->strength, {1e-100, 1e100, true, true, "1e-100 to 1e100"},
          "V0 in units of rho c^2 R^2; it only shifts the wall");
}

std::unique_ptr<ContactResponse> make_response(const Contact& contact, Tail tail, const ContactGrid& grid, double speed,
                                               double step, const Poll& poll) {
  if (const auto* soft = std::get_if<ExponentialWall>(&contact.wall)) {
    return std::make_unique<ExponentialResponse>(*soft, contact, grid, speed);
  }
  if (tail == Tail::quasistatic) {
    return std::make_unique<QuasistaticTail>(contact, grid, speed, step, poll);
  }
  return std::make_unique<RadiatingTail>(contact, grid, speed, step, poll);
}

}  // namespace stoss
