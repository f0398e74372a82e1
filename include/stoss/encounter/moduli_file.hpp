#pragma once

#include <string>
#include <string_view>

#include "stoss/relaxation/measurement.hpp"

namespace stoss {

/// Reads moduli from a text with a header and values separated by commas, semicolons or tabs. The columns are
///
///   f or frequency in Hz, or omega in rad/s
///   E' or storage
///   E'' or loss, or tan_delta
///
/// in any order and in upper or lower case, moduli with a unit behind them, as in `E' [MPa]`, or in Pa. Lines that
/// begin with # and empty ones do not count.
/// @param where named by refusals @throws InvalidInput with the number of the line, for frequencies that do not rise,
/// numbers that are not positive, and tan δ without E′
[[nodiscard]] Moduli moduli_from_csv(std::string_view text, const std::string& where);

}  // namespace stoss
