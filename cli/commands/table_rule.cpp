// stoss table --oblique: the collision rule as a function, for other programs.
#include <vector>

#include "commands/table.hpp"
#include "output/output.hpp"
#include "process/process.hpp"
#include "stoss/encounter/laws.hpp"
#include "stoss/table/adaptive_rule.hpp"

namespace stoss::cli {
namespace {

nlohmann::ordered_json grid_of(const std::string& quantity, const RuleGrid& grid, const std::vector<double>& nodes,
                               const std::vector<double>& errors, const TableJob& job) {
  nlohmann::ordered_json record{{"quantity", quantity}};
  for (const double each : grid.speeds) record["speed"].push_back(each * job.unit);
  record["slip"] = grid.slips;
  record["ratio"] = grid.ratios;
  for (const Estimate& each : grid.values) record["error"].push_back(each.error);
  record["nodes"] = nodes;
  record["error_of_cells"] = errors;
  return record;
}

std::string as_json(const TableArguments& arguments, const TableJob& job, const RuleTable& rule) {
  auto document = json_head(arguments, job,
                            "ln(speed), in slip = (|s| - mu speed)/(|s| + mu speed) and in (ratio - 1)/(ratio + 1)");
  const RuleValues& values = rule.values();
  document["greatest_error"] = rule.greatest_restitution_error();
  document["greatest_sliding_error"] = rule.greatest_sliding_error();
  document["inverse_is_same"] = values.alike;
  if (values.friction) document["friction"] = *values.friction;
  document["records"] = {
      grid_of("restitution", values.restitution, rule.restitution_nodes(), rule.restitution_errors(), job),
      grid_of("sliding", values.sliding, rule.sliding_nodes(), rule.sliding_errors(), job)};
  document["complete"] = true;
  return json_text(document);
}

RuleTable rule_of(const TableArguments& arguments, const TableJob& job) {
  const RuleTableOptions options{.error = arguments.error,
                                 .tolerance = arguments.tolerance,
                                 .friction = arguments.friction,
                                 .beyond = beyond(arguments),
                                 .threads = arguments.threads,
                                 .poll = heed_interrupts};
  if (arguments.ratio.empty()) return rule_table(refinable(job.encounter), job.speeds[0], job.speeds[1], options);
  const auto [smallest, largest] = parse_ratios(arguments.ratio);
  return rule_table(mixture(job.encounter), job.speeds[0], job.speeds[1], smallest, largest, options);
}

}  // namespace

std::string text_of_rule(const TableArguments& arguments, const TableJob& job) {
  const RuleTable rule = rule_of(arguments, job);
  return arguments.format == "c" ? c_header(rule, label(arguments, job)) : as_json(arguments, job, rule);
}

}  // namespace stoss::cli
