#pragma once

#include <string>

#include "job.hpp"

namespace stoss::cli {

/// Names of the columns of stoss restitution --method extrapolate.
[[nodiscard]] std::string extrapolate_columns(const Job& job);

/// @throws InvalidInput for speeds at which the paper's method does not work, and as the core
void check_extrapolate(const Job& job);

/// Computes the rows that the sweep does not have yet. @throws Interrupted, OutputError
void extrapolate(const Job& job, Sweep& sweep, Report& report);

}  // namespace stoss::cli
