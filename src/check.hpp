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

/// A computed number, with six digits or so many.
[[nodiscard]] std::string rounded(double value, int digits = 6);

/// A computed end of what is allowed, with six digits: rounded towards the inside, so that what is shown is allowed.
[[nodiscard]] std::string shown_least(double value);
[[nodiscard]] std::string shown_most(double value);

}  // namespace stoss

/// Ranges of inputs, in units of the first body: the core refuses by them, and the table of inputs shows them.
namespace stoss::ranges {

inline constexpr Range speed{1e-8, 1.0, true, true, "1e-8 to 1"};
inline constexpr Range along{-1.0, 1.0, true, true, "-1 to 1"};
inline constexpr Range friction{0.0, 5.0, true, true, "0 to 5"};
inline constexpr Range ratio{1e-3, 1e3, true, true, "0.001 to 1000"};
inline constexpr Range tolerance{1e-15, 0.5, true, true, "1e-15 to 0.5"};
inline constexpr Range absolute{0.0, 0.5, true, true, "0 to 0.5"};
inline constexpr Range sliding_tolerance{1e-6, 0.5, true, true, "1e-6 to 0.5"};
inline constexpr Range rule_tolerance{1e-4, 0.5, true, true, "1e-4 to 0.5"};
inline constexpr Range force_tolerance{1e-5, 0.5, true, true, "1e-5 to 0.5"};
inline constexpr Range threshold{0.0, 0.9, true, true, "0 to 0.9"};
inline constexpr Range points{16.0, 1e5, true, true, "16 to 100000"};
inline constexpr Range place{0.0, 1e6, true, true, "0 to 1e6"};
inline constexpr Range row_tolerance{1e-6, 1.0, true, true, "1e-6 to 1"};
inline constexpr Range sample_error{1e-9, 0.5, true, true, "1e-9 to 0.5"};
inline constexpr Range table_error{1e-7, 0.1, true, true, "1e-7 to 0.1"};
inline constexpr Range energy{0.0, 1e6, true, true, "0 to 1e6"};
inline constexpr Range samples{1.0, 1e6, true, true, "1 to 1000000"};
inline constexpr Range seed{0.0, 2147483647.0, true, true, "0 to 2147483647"};
inline constexpr Range count{1.0, 1e9, true, true, "1 to 1000000000"};
inline constexpr Range flight_time{0.0, 1e12, false, true, "above 0 to 1e12"};
inline constexpr Range gravity{1e-15, 1e3, true, true, "1e-15 to 1000"};
inline constexpr Range decay_time{0.0, 1e15, true, true, "0 to 1e15"};
inline constexpr Range nodes{16.0, 4096.0, true, true, "16 to 4096"};
inline constexpr Range adhesion{0.0, 1e6, true, true, "0 to 1e6"};

}  // namespace stoss::ranges
