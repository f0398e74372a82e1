#include "impact/ending.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "stoss/errors.hpp"

namespace stoss {

Rest::Rest(const Contact& contact, double speed, double steps)
    : contact_(contact), ending_(ending(contact)), speed_(speed), half_(std::lround(0.5 * steps)) {}

bool Rest::ends(const Slowing& now) {
  if (!ending_.may_stay) return false;
  rebound_ = rebound_of_staying(contact_, speed_, before_, now);
  return stays() || (!now.touches && now.velocity < 0.0);
}

void Rest::apply(Impact& impact) const {
  if (!stays()) return;
  impact.restitution = 0.0;
  impact.lost_fraction = 1.0;
  impact.remaining = *rebound_ * *rebound_;
  impact.contact_time = std::min(impact.contact_time, ending_.known);  // it does not end
  EnergyLedger& ledger = impact.energy;
  ledger.vibration += ledger.translation;
  ledger.lost_to_second += ledger.translation;
  ledger.translation = 0.0;
}

Outlasted::Outlasted(double contact_time, double echo)
    : NotConverged("impact: the contact lasts " + std::to_string(contact_time) +
                   " R/c, and the echo from where the part of the larger body ends is back after " +
                   std::to_string(echo)) {}

void require_known_for(const Contact& contact, double contact_time) {
  const double known = ending(contact).known;
  if (contact_time > known) throw Outlasted(contact_time, known);
}

WholeBodies::WholeBodies(const Contact& contact, const Snapshot& start)
    : contact_(contact),
      start_(start),
      part_(contact.mass / contact.whole_mass),
      energy_(1.0 + start.translation * (1.0 / part_ - 1.0)),
      force_(contact.first->mass / whole_mass(*contact.first)) {}

void WholeBodies::convert(Snapshot& now) const {
  if (part_ == 1.0) return;
  const double lost = 1.0 - now.velocity / start_.velocity;
  const double velocity = 1.0 - part_ * lost;
  const double free = start_.center + start_.velocity * now.time;
  now.center = free - part_ * (free - now.center);
  now.velocity = start_.velocity * velocity;
  now.force *= force_;
  now.translation = velocity * velocity * start_.translation / part_ / energy_;
  now.vibration = (now.vibration + (1.0 - part_) * lost * lost * start_.translation) / energy_;
  now.dissipated /= energy_;
  now.yielded /= energy_;
  now.stored /= energy_;
  now.unresolved /= energy_;
}

void WholeBodies::convert(Impact& impact) const {
  require_known_for(contact_, impact.contact_time);
  if (part_ == 1.0) return;
  EnergyLedger& ledger = impact.energy;
  const double lost = 1.0 + impact.restitution;
  const double beyond = (1.0 - part_) * lost * lost * start_.translation / energy_;
  for (double* each : {&ledger.vibration, &ledger.dissipated, &ledger.yielded, &ledger.unresolved, &ledger.stored,
                       &ledger.lost_to_first, &ledger.lost_to_second, &impact.energy_error}) {
    *each /= energy_;
  }
  for (ModeEnergy& mode : ledger.modes) {
    mode.before /= energy_;
    mode.after /= energy_;
    mode.average /= energy_;
  }
  ledger.vibration += beyond;
  (contact_.first->part.size < 1.0 ? ledger.lost_to_first : ledger.lost_to_second) += beyond;
  impact.restitution = part_ * lost - 1.0;
  impact.lost_fraction = 1.0 - impact.restitution * impact.restitution;
  ledger.translation = impact.restitution * impact.restitution * start_.translation / part_ / energy_;
  impact.max_force *= force_;
}

}  // namespace stoss
