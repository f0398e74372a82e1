#pragma once

#include "contact/ending.hpp"
#include "contact/zener.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss {

/// Watches whether a body stays on what gives way (rebound_of_staying).
class Rest {
 public:
  /// @param steps after which it is asked at first
  Rest(const Contact& contact, double speed, double steps);

  /// Adds an instant, and keeps the one at half of the time.
  template <typename Instant>
  void watch(long step, const Instant& instant) {
    if (ending_.may_stay && step == half_) before_ = instant();
  }

  /// Asks whether it stays. @returns whether the impact ends so, as it has parted or stays
  [[nodiscard]] bool ends(const Slowing& now);

  [[nodiscard]] bool stays() const { return rebound_.has_value(); }

  /// Makes the result that of a body that stays, if it does: ε = 0, and the plate takes what it still has.
  void apply(Impact& impact) const;

 private:
  const Contact& contact_;
  Ending ending_;
  double speed_;
  long half_;
  Slowing before_;
  std::optional<double> rebound_;
};

/// A contact has lasted longer than the part of a body that is there stands for it.
class Outlasted : public NotConverged {
 public:
  Outlasted(double contact_time, double echo);
};

/// @throws Outlasted for a contact of this time
void require_known_for(const Contact& contact, double contact_time);

/// The motion and the energies of whole bodies, of which the near side of one has met the other (BodyPart).
///
/// Until the first echo the force is that of the whole bodies, and moves them with their reduced mass μ instead of that
/// of the part, κμ. With w the velocity of the part over that before the impact, v,
///
///   velocity   v [1 − κ(1 − w)],   at the end   ε = κ(1 + ε_part) − 1,
///
/// and what the part has of energy more than the whole by its translation, κ(1 − κ)(1 − w)² of ½μv², is vibration of
/// the whole. Where both bodies are whole nothing changes.
class WholeBodies {
 public:
  /// @param start of the impact
  WholeBodies(const Contact& contact, const Snapshot& start);

  /// Makes an instant that of the whole bodies.
  void convert(Snapshot& now) const;

  /// Makes a result that of the whole bodies; the final state remains that of the part.
  /// @throws Outlasted if the contact has lasted longer than the first echo of the part takes
  void convert(Impact& impact) const;

 private:
  const Contact& contact_;
  Snapshot start_;
  double part_;    // κ
  double energy_;  // at the start, over that with the part
  double force_;   // unit of force of the part, in that of the whole
};

}  // namespace stoss
