#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "check.hpp"
#include "contact/zener.hpp"
#include "impact/ending.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss {

inline constexpr double duration_margin = 1.5;  // of a half-space, over what is expected of the contact

/// A contact with a plate that lasts longer than is computed: no other cutoff would end it.
class DoesNotEnd : public NotConverged {
 public:
  explicit DoesNotEnd(double time)
      : NotConverged("restitution: the contact with the plate has not ended after " + shown(std::round(time)) +
                     " R/c (the body stays on it, or leaves later than is computed)") {}

 protected:
  explicit DoesNotEnd(const std::string& reason) : NotConverged("restitution: " + reason) {}
};

/// The same, known before it is computed.
class StaysUnseen : public DoesNotEnd {
 public:
  StaysUnseen()
      : DoesNotEnd(
            std::string("the plate is so thin that the ball presses into it faster than waves of bending spread, "
                        "and stays on it for longer than is computed (a thicker plate, or a lower speed)")) {}
};

/// compute(contact) with the contact at a cutoff; with a half-space or a plate made anew for a longer time where an
/// impact outlasts it.
/// @param stretch of the half-space (RefinableContact::stretch); becomes greater
/// @throws DoesNotEnd where it outlasts a plate far longer than is expected at this speed
template <typename Compute>
auto retry_until_contact_ends(const RefinableContact& contact, double cutoff, double speed, double& stretch,
                              const Poll& poll, const Compute& compute) {
  constexpr double room_on_a_plate = 8.0;  // of which what is expected is rough
  const double longest = duration_margin * stretch / std::numbers::sqrt2;
  const double most = room_on_a_plate * contact.stretch(speed);
  if (const Contact& probe = contact.at(0, poll); stays_unseen(probe, speed, most * echo_time(probe))) {
    throw StaysUnseen();
  }
  for (;; stretch *= std::numbers::sqrt2) {
    const Contact& resolved = contact.at(cutoff, stretch, poll);
    try {
      return compute(resolved);
    } catch (const Outlasted&) {
      if (resolved.keeps_displacement) {
        if (stretch >= most) throw DoesNotEnd(echo_time(resolved));
      } else if (!resolved.unbounded || stretch > longest) {
        throw;
      }
    }
  }
}

/// The stretch of a half-space or a plate for which an impact ends before its echo, as a coarse one tells:
/// RefinableContact::stretch, or more of what is softer and heavier than that expects.
[[nodiscard]] double lasting_stretch(const RefinableContact& contact, double speed, const Poll& poll);

}  // namespace stoss
