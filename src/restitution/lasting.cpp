#include "restitution/lasting.hpp"

#include "stoss/impact/impact.hpp"

namespace stoss {
namespace {

/// Whether an impact ends before the echo, or the body stays. A coarse contact may end a little earlier than a fine
/// one.
bool ends(const Contact& contact, double speed, const Poll& poll) {
  constexpr double margin = 1.1;
  try {
    const Impact coarse = impact(contact, speed, {.poll = poll});
    return coarse.remaining > 0.0 || margin * coarse.contact_time < echo_time(contact);
  } catch (const Outlasted&) {
    return false;
  } catch (const NotConverged&) {  // a finer one will say why
    return true;
  } catch (const InvalidInput&) {
    return true;
  }
}

}  // namespace

double lasting_stretch(const RefinableContact& contact, double speed, const Poll& poll) {
  constexpr double growth = std::numbers::sqrt2, most = 8.0;
  const double expected = contact.stretch(speed);
  double stretch = expected;
  if (!contact.at(0, poll).unbounded) return stretch;
  while (!ends(contact.at(contact.cutoff(0) / stretch, stretch, poll), speed, poll)) {
    if (growth * stretch > most * expected) return expected;  // a finer one will say so
    stretch *= growth;
  }
  return stretch;
}

}  // namespace stoss
