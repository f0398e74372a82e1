// How a mode swings by itself in the material of its body.
#include "contact/group_loss.hpp"
#include "stoss/contact/contact.hpp"

namespace stoss {

FreeMode free_mode(const Contact& contact, std::size_t group, std::size_t index) {
  const double omega = contact.groups[group].omega[index];
  const GroupLoss loss(contact, group);
  if (!loss.relaxes()) return {0.5 * loss.loss_time() * omega * omega, omega};
  const LossyOscillator mode = relaxing_oscillator(omega, loss.rates(index));
  return {mode.gamma, mode.frequency};
}

}  // namespace stoss
