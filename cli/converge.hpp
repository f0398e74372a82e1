#pragma once

#include <string>

#include "sweep.hpp"

namespace stoss::cli {

/// Names of the columns of stoss restitution --method converge.
[[nodiscard]] std::string converge_columns(const Job& job);

/// @throws InvalidInput for what the core does not accept, before anything is computed
void check_converge(const Job& job, double tolerance, int threads);

/// Computes the rows that the sweep does not have yet. @throws Interrupted, OutputError
void converge(Sweep& sweep, Report& report, double tolerance, int threads);

}  // namespace stoss::cli
