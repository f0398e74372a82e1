// Rows at several speeds, by several threads.
#include "stoss/row/curve.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "check.hpp"
#include "restitution/ordered_jobs.hpp"
#include "row/motion.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// A case of which too few motions end.
RowResult failed(const Row& row, const std::string& reason) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  RowResult result;
  result.velocities_after.assign(row.bodies.size(), {none, none});
  result.translation = {none, none};
  RowImpact& finest = result.finest;
  finest.cutoff = finest.time = finest.energy_error = finest.momentum_error = finest.strain = none;
  finest.energy = {none, none, none, none, none, none};
  const std::size_t joints = row.bodies.size() - 1 + (row.wall_before ? 1 : 0) + (row.wall_after ? 1 : 0);
  for (std::size_t k = 0; k < joints; ++k) {
    const int left = static_cast<int>(k) - (row.wall_before ? 1 : 0);
    finest.contacts.push_back({left, none, none, 0, none, none, none});
  }
  result.reason = reason;
  return result;
}

}  // namespace

void check(const Row& row, const std::vector<std::vector<double>>& speeds, const RowCurveOptions& options) {
  require("threads", static_cast<long>(options.threads), 0, 1024, "0 for as many as the machine has");
  require_tolerance(options.each);
  for (const std::vector<double>& each : speeds) (void)fastest_time_scale(row, each, options.each.poll);
}

void row_curve(const Row& row, const std::vector<std::vector<double>>& speeds, const RowCurveOptions& options,
               const RowCurveObserver& observer) {
  require("threads", static_cast<long>(options.threads), 0, 1024, "0 for as many as the machine has");
  const auto job = [&](std::size_t k, const Poll& heed) {
    try {
      RowOptions each = options.each;
      each.poll = heed;
      return stoss::row(row, speeds[k], each);
    } catch (const NotConverged& error) {
      return failed(row, error.what());
    }
  };
  run_in_order<RowResult>(
      speeds.size(), options.threads, job, [&](std::size_t k, RowResult&& result) { observer(k, result); },
      options.each.poll);
}

double fastest_time_scale(const Row& row, const std::vector<double>& speeds, const Poll& poll) {
  constexpr double few = 5.656854;  // any cutoff does
  const MadeRow probe = made_row(row, speeds, few, poll);
  double fastest = std::numeric_limits<double>::infinity();
  for (const MadeRow::Joint& joint : probe.joints) {
    const double unit = probe.units_of(joint).time;
    fastest = std::min(fastest, time_scale(*joint.contact) * unit);
  }
  return fastest;
}

}  // namespace stoss
