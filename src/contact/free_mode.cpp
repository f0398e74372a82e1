// How a mode swings by itself in the material of its body.
#include "relaxation/oscillator.hpp"
#include "stoss/contact/contact.hpp"

namespace stoss {

FreeMode free_mode(const Contact& contact, std::size_t group, double omega) {
  const Relaxation its = relaxation(contact, group);
  if (its.terms.empty()) return {0.5 * loss_time(contact, group) * omega * omega, omega};
  const LossyOscillator mode = relaxing_oscillator(omega, Rates(its));
  return {mode.gamma, mode.frequency};
}

}  // namespace stoss
