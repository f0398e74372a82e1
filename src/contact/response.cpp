#include "contact/response.hpp"

#include "contact/exponential_wall.hpp"
#include "contact/tails.hpp"

namespace stoss {

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

bool follows_at_once(const Contact& contact, Tail tail) {
  const bool hard = std::holds_alternative<HardWall>(contact.wall);
  return hard && tail == Tail::radiating && longest_loss_time(contact) > 0.0;
}

}  // namespace stoss
