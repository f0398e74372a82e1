#pragma once

#include <optional>
#include <string>

#include "output/fields.hpp"

namespace stoss::cli {

/// What rows say of yielding: the speed at which it begins, and whether an impact is faster. Nothing where no yield
/// strength is given.
struct Yielding {
  Units units;                  ///< in SI
  std::optional<double> speed;  ///< m/s

  [[nodiscard]] Columns columns() const;

  /// @param impact speed of it, c of the first body
  [[nodiscard]] Row row(double impact) const;

  [[nodiscard]] bool is_below(double impact) const { return speed && impact * units.si->speed > *speed; }
};

[[nodiscard]] inline Yielding yielding(const Encounter& encounter) {
  return {units_of(encounter), yield_speed(encounter)};
}

/// The warning about impacts beyond the speed at which yielding begins, m/s.
[[nodiscard]] std::string yield_warning(double yield_speed);

}  // namespace stoss::cli
