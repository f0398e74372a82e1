#include <string>
#include <vector>

#include "c/interface.hpp"
#include "stoss/encounter/row.hpp"
#include "stoss/errors.hpp"

extern "C" int stoss_row(const char* json, const double* speeds, size_t count, double tolerance,
                         const stoss_control* control, stoss_estimate* velocities) {
  return stoss::c::guarded([&] {
    stoss::c::require_given(json, "json");
    stoss::c::require_given(speeds, "speeds");
    stoss::c::require_given(velocities, "velocities");
    const stoss::GivenRow row = stoss::row_from_json(json);
    if (count != row.bodies.size()) {
      throw stoss::InvalidInput::out_of_range("count", std::to_string(count), std::to_string(row.bodies.size()),
                                              "the bodies of the row");
    }
    const stoss::RowResult result =
        stoss::row(row, {speeds, speeds + count}, {.tolerance = tolerance, .poll = stoss::c::poll_of(control)});
    const double unit = stoss::speed_unit(stoss::first_of(row));
    for (std::size_t i = 0; i < count; ++i) {
      const stoss::Estimate& its = result.velocities_after[i];
      velocities[i] = {its.value * unit, its.error * unit};
    }
    if (!result.converged) throw stoss::NotConverged(result.reason);
  });
}
