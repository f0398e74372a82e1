// stoss table --oblique: the collision rule as a function, for other programs.
#include <fmt/format.h>

#include <vector>

#include "app.hpp"
#include "commands/table.hpp"
#include "output/output.hpp"
#include "output/output_options.hpp"
#include "process/process.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/laws.hpp"
#include "stoss/errors.hpp"
#include "stoss/table/adaptive_rule.hpp"
#include "stoss/table/two_column.hpp"

namespace stoss::cli {
namespace {

nlohmann::ordered_json grid_of(const std::string& quantity, const TableValues& grid, const std::vector<double>& nodes,
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
  auto document =
      json_head(arguments, job, "ln(speed), in slip = (|s| - mu speed)/(|s| + mu speed) and in (ratio - 1)/(ratio + 1)",
                rule.greatest_restitution_error());
  const RuleValues& values = rule.values();
  document["greatest_sliding_error"] = rule.greatest_sliding_error();
  document["inverse_is_same"] = values.sliding.alike;
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
                                 .poll = waiting(arguments.output, "table of the collision rule")};
  if (arguments.ratio.empty()) return rule_table(refinable(job.encounter), job.speeds[0], job.speeds[1], options);
  const auto [smallest, largest] = ratios_of(arguments);
  return rule_table(mixture(job.encounter), job.speeds[0], job.speeds[1], smallest, largest, options);
}

/// The error of s′ is over the motion before, which may be far more than s′.
void warn_of_wide_contacts(const TableArguments& arguments, const RuleTable& rule) {
  constexpr double noticeable = 0.02;
  if (rule.greatest_sliding_error() <= noticeable) return;
  arguments.output.warn(fmt::format(
      "sliding afterwards is off by up to {:.2g} of |v_t| + |spin R| + friction v, as the sliding before does "
      "not tell velocity from spin, (a/R)^2: where they nearly cancel, much of it",
      rule.greatest_sliding_error()));
}

}  // namespace

std::string text_of_rule(const TableArguments& arguments, const TableJob& job) {
  if (arguments.format == "two-column") {
    TableArguments half = arguments;  // the rest is for the straight lines between the rows
    half.tolerance *= 0.5;
    return two_column(rule_of(half, job), job.typed[0] / job.unit, arguments.tolerance);
  }
  const RuleTable rule = rule_of(arguments, job);
  warn_of_wide_contacts(arguments, rule);
  return is_code(arguments.format) ? code(arguments, job, rule) : as_json(arguments, job, rule);
}

void write_netcdf_of_rule(const TableArguments& arguments, const TableJob& job) {
  if (!arguments.oblique)
    throw InvalidInput::out_of_range("format", "netcdf", "only with --oblique", "the whole collision rule");
  if (arguments.output.path.empty()) throw InvalidInput::missing("output", "a file, which netcdf needs");
  std::vector<std::string> words{"table",
                                 fmt::format("--error={}", arguments.error),
                                 fmt::format("--tolerance={}", arguments.tolerance),
                                 fmt::format("--threads={}", arguments.threads),
                                 "--output=" + arguments.output.path,
                                 "--speed",
                                 fmt::format("{}", job.typed[0]),
                                 fmt::format("{}", job.typed[1])};
  if (arguments.friction) words.push_back(fmt::format("--friction={}", *arguments.friction));
  if (!arguments.ratio.empty()) {
    const auto [smallest, largest] = ratios_of(arguments);
    words.insert(words.end(), {"--ratio", fmt::format("{}", smallest), fmt::format("{}", largest)});
  }
  words.insert(words.end(), {"--", to_json(job.encounter)});
  become_python(words);
}

}  // namespace stoss::cli
