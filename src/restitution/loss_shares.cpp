#include "restitution/loss_shares.hpp"

namespace stoss {

double translation_before(const EnergyLedger& ledger) {
  double share = 1.0;
  for (const ModeEnergy& mode : ledger.modes) share -= mode.before;
  return share;
}

void apportion_losses(const Contact& contact, Restitution& result) {
  const EnergyLedger& ledger = result.finest.energy;
  const double unit = translation_before(ledger);
  const double given_back = unit * (result.finest.lost_fraction - result.lost_fraction.value);
  const double by_first = contact.unbounded ? 1.0 : unresolved_share(contact);
  const double first = ledger.lost_to_first - by_first * given_back;
  const double second = ledger.lost_to_second - (1.0 - by_first) * given_back;
  const double whole = 1.0 - unit * (1.0 - result.lost_fraction.value);
  const double counted = first + second;
  const double scale = counted == 0.0 ? 1.0 : whole / counted;
  result.lost_to_first = scale * first;
  result.lost_to_second = scale * second;
  result.dissipated = scale * ledger.dissipated;
  result.yielded = scale * ledger.yielded;
}

}  // namespace stoss
