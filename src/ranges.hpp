#pragma once

#include "check.hpp"

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
