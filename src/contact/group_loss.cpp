#include "contact/group_loss.hpp"

#include <algorithm>
#include <cmath>

#include "contact/unit_ratios.hpp"

namespace stoss {

GroupLoss::GroupLoss(const Contact& contact, std::size_t group)
    : group_(contact.groups[group]), loss_time_(stoss::loss_time(contact, group)), same_(relaxation(contact, group)) {
  const int number = group < contact.first_groups ? 0 : 1;
  const auto body = body_of(contact, number);
  if (!body->layers.empty()) layers_.emplace(body->layers, number == 0 ? 1.0 : units_of(contact, 1).time);
}

Rates GroupLoss::rates(std::size_t index) const {
  if (!layers_) return same_;
  const std::size_t layers = group_.moduli.size() / group_.omega.size();
  return layers_->of(group_.moduli.data() + index * layers);
}

FreeMode GroupLoss::dashpot(std::size_t index, double step) const {
  const double omega = group_.omega[index];
  if (!relaxes()) return {0.5 * loss_time_ * omega * omega, omega};
  if (!layers_) return {0.0, omega};
  constexpr double fastest = 3.0;  // of kicks, less than half a period apart
  const Rates its = rates(index);
  const double frequency = its.rate.empty() ? omega * std::sqrt(its.relaxed) : omega;
  return {0.5 * its.viscous * omega * omega, std::min(frequency, fastest / step)};
}

}  // namespace stoss
