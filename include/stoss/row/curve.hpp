#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "stoss/row/row.hpp"

namespace stoss {

/// How one row at several speeds is computed.
struct RowCurveOptions {
  RowOptions each{};  ///< `poll` is called on the calling thread
  int threads = 0;    ///< 0: as many as the machine has; results do not depend on it
};

/// Receives the results in the order of their speeds, on the calling thread: each as soon as it and all before it are
/// there. What it throws ends the rest.
using RowCurveObserver = std::function<void(std::size_t index, const RowResult& result)>;

/// Moves the same row from several sets of speeds, as `row` does. A case that does not converge does not end the rest:
/// it has a reason, and NaN where too few of its motions end.
/// @param speeds of all bodies of the row, to the right, c of the first body, for each case
/// @throws InvalidInput as row; what observer and poll throw, after the motions under way have stopped
void row_curve(const Row& row, const std::vector<std::vector<double>>& speeds, const RowCurveOptions& options,
               const RowCurveObserver& observer);

/// Refuses what row_curve would refuse, before anything is computed. @throws InvalidInput as row_curve
void check(const Row& row, const std::vector<std::vector<double>>& speeds, const RowCurveOptions& options);

/// The least R/c in which two neighbours of a row answer each other, or a body its wall, in R/c of the first body:
/// cutoffs over it resolve rows of any bodies to the same extent. @throws InvalidInput as row_impact
[[nodiscard]] double fastest_time_scale(const Row& row, const std::vector<double>& speeds, const Poll& poll = {});

}  // namespace stoss
