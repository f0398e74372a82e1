#include "commands/oblique_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "stoss/impact/quantities.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss::cli {

Fields<ObliqueRestitution> oblique_fields(const Units& units, bool spinning) {
  return Fields<ObliqueRestitution>(
      oblique_quantities(), units,
      {{"restitution", {.width = spinning ? 13 : 22, .with_error = !spinning}},
       {"tangential_restitution", {.width = 25, .with_error = true, .mark = {{"converged", false}}}},
       {"cutoff", {.in_si = false}}});
}

nlohmann::ordered_json oblique_details(const ObliqueRestitution& result) {
  nlohmann::ordered_json object{{"runs", to_json(oblique_run_quantities(), result.runs)}};
  if (!result.runs.empty()) {
    object["ledger"] = to_json(oblique_ledger_quantities(), std::vector{result.finest.energy}).front();
  }
  if (!result.converged) object["reason"] = result.reason;
  return object;
}

void NeglectedNote::take(const Columns& columns, const Row& row) {
  const double tangential = number(*find(columns, row, "coupling_tangential_restitution"));
  const double normal = number(*find(columns, row, "coupling_restitution"));
  unknown_ = unknown_ || std::isnan(tangential);
  tangential_ = std::fmax(tangential_, std::abs(tangential));
  normal_ = std::fmax(normal_, std::abs(normal));
}

void NeglectedNote::say(const OutputOptions& output, double tolerance) const {
  if (output.chosen_format() != Format::table) return;
  if (unknown_) {
    output.warn(
        "how much neglected coupling may change tangential_restitution is unknown (friction so high is ill-posed)");
  } else if (tangential_ > tolerance) {
    output.warn(
        fmt::format("neglected coupling may change tangential_restitution by up to {:.2g}, restitution by up to {:.2g}",
                    tangential_, normal_));
  }
}

}  // namespace stoss::cli
