#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace stoss {

/// A closed or half-open interval of allowed values; `text` is how an error message names it.
struct Range {
  double low;
  double high;
  bool low_included;
  bool high_included;
  std::string_view text;
};

/// Throws InvalidInput unless `value` is a finite number inside `range`.
void require(std::string_view name, double value, const Range& range, std::string_view hint);

/// Throws InvalidInput unless low <= value <= high.
void require(std::string_view name, std::int64_t value, std::int64_t low, std::int64_t high, std::string_view hint);

/// Throws InvalidInput unless `poisson` is a 2-D Poisson's ratio for which the modes are tested, −0.95 … 0.995.
void require_poisson(double poisson);

/// Throws InvalidInput unless `speed` is one that an impact can have, 1e-8 … 1 c.
void require_speed(double speed);

/// Throws InvalidInput unless `loss_time`, in R/c of its body, is one that an impact is computed for, 0 … 1e5.
void require_loss_time(double loss_time);

/// Throws InvalidInput unless `tolerance` is a relative error that can be asked for, 1e-15 … 0.5, and `absolute` an
/// error of 1 − ε², 0 … 0.5.
void require_tolerance(double tolerance, double absolute);

/// A loss time in another unit of time: none is none, even where that unit is 0. @param rate one over the unit
[[nodiscard]] inline double in_own_time(double loss_time, double rate) {
  return loss_time == 0.0 ? 0.0 : loss_time * rate;
}

/// A number with ten digits, or as many as tell it from every other one: as it was given.
[[nodiscard]] std::string shown(double value);

/// A computed number, with six digits.
[[nodiscard]] std::string rounded(double value);

/// A computed end of what is allowed, with six digits: rounded towards the inside, so that what is shown is allowed.
[[nodiscard]] std::string shown_least(double value);
[[nodiscard]] std::string shown_most(double value);

}  // namespace stoss
