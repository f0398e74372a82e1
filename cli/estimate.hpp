#pragma once

#include <string>

#include "record.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss::cli {

/// `value ± error` to the digits that the error leaves, two of the error's own; at most 12 decimals, and from 8 on in
/// the short form 0.94706123(12), of which small values that need more make 3.49794(14)e-19.
[[nodiscard]] std::string with_error(double value, double error);

/// The error of a value as CSV and JSON have it: the word `unknown` where a finite value has none that is finite.
[[nodiscard]] Value error_of(const Estimate& estimate);

/// Adds the value as `key` and its error as `key`_error.
/// @param width of the value's column in the table, which has the word `unknown` in place of a value without an error
/// @param shown what the table has in place of the value
void add_estimate(Record& record, const std::string& key, const std::string& unit, const Estimate& estimate, int width,
                  const std::string& shown = {});

}  // namespace stoss::cli
