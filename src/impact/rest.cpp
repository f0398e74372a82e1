#include "impact/rest.hpp"

#include <algorithm>
#include <cmath>

namespace stoss {

Rest::Rest(const Contact& contact, double speed, double steps)
    : contact_(contact), speed_(speed), half_(std::lround(0.5 * steps)) {}

bool Rest::ends(const Slowing& now) {
  if (!contact_.gives_way) return false;
  rebound_ = rebound_of_staying(contact_, speed_, before_, now);
  return stays() || (!now.touches && now.velocity < 0.0);
}

void Rest::show(Impact& impact) const {
  if (!stays()) return;
  impact.restitution = 0.0;
  impact.lost_fraction = 1.0;
  impact.remaining = *rebound_ * *rebound_;
  impact.contact_time = std::min(impact.contact_time, echo_time(contact_));  // it does not end
  EnergyLedger& ledger = impact.energy;
  ledger.vibration += ledger.translation;
  ledger.lost_to_second += ledger.translation;
  ledger.translation = 0.0;
}

}  // namespace stoss
