#pragma once

#include "contact/staying.hpp"
#include "stoss/contact/contact.hpp"
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
    if (contact_.gives_way && step == half_) before_ = instant();
  }

  /// Asks whether it stays. @returns whether the impact ends so, as it has parted or stays
  [[nodiscard]] bool ends(const Slowing& now);

  [[nodiscard]] bool stays() const { return rebound_.has_value(); }

  /// Makes the result that of a body that stays, if it does: ε = 0, and the plate takes what it still has.
  void show(Impact& impact) const;

 private:
  const Contact& contact_;
  double speed_;
  long half_;
  Slowing before_;
  std::optional<double> rebound_;
};

}  // namespace stoss
