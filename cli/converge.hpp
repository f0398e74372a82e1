#pragma once

#include <string>

#include "job.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss::cli {

/// Names of the columns of stoss restitution --method converge.
[[nodiscard]] std::string converge_columns(const Job& job);

/// @throws InvalidInput for what the core does not accept, before anything is computed
void check_converge(const Job& job, const CurveOptions& asked);

/// Computes the rows that the sweep does not have yet. @throws Interrupted, OutputError
/// @param asked tolerances, threads and vibration
void converge(const Job& job, Sweep& sweep, Report& report, const CurveOptions& asked);

}  // namespace stoss::cli
