// stoss table: the coefficient of restitution as a function of the speed, for other programs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app.hpp"
#include "commands/table.hpp"
#include "output/output_options.hpp"
#include "process/process.hpp"
#include "stoss/encounter/laws.hpp"
#include "stoss/errors.hpp"
#include "stoss/prediction/prediction.hpp"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/adaptive_pairs.hpp"
#include "stoss/table/two_column.hpp"

namespace stoss::cli {
namespace {

void check_format(const TableArguments& arguments) {
  for (const std::string option : {"tolerance", "friction"}) {
    if (arguments.oblique || !given(*arguments.command, "--" + option)) continue;
    throw InvalidInput::out_of_range(fmt::format("{}", option), fmt::format("--{}", option), "only with --oblique",
                                     "the whole collision rule");
  }
  for (const std::string option : {"oblique", "ratio"}) {
    if (!arguments.predicted || !given(*arguments.command, "--" + option)) continue;
    throw InvalidInput::out_of_range(fmt::format("{}", option), fmt::format("--{} with --predict", option),
                                     "only without");
  }
  if (arguments.adhesion && !arguments.predicted) {
    throw InvalidInput::out_of_range("adhesion", "--adhesion", "only with --predict", "yield and adhesion are models");
  }
  const std::string& format = arguments.format;
  const auto require = [&](const std::string& option, bool goes_with, const std::string& allowed) {
    if (goes_with || !given(*arguments.command, "--" + option)) return;
    throw InvalidInput::out_of_range(fmt::format("{}", option), fmt::format("--{} with --format {}", option, format),
                                     fmt::format("only with {}", allowed));
  };
  require("name", is_code(format), "--format c, rust or js");
  require("ratio", format != "two-column", "c, rust, js, json and, with --oblique, netcdf");
  require("beyond", is_code(format) || format == "json", "c, rust, js and json (who reads the values decides)");
}

TableJob make_job(const TableArguments& arguments) {
  Encounter encounter = arguments.who.encounter();
  const Units units = units_of(encounter);
  if (arguments.oblique && arguments.format == "two-column") {
    const ApproachOptions& given = arguments.approach;
    const double speed = ApproachOptions{Question::restitution, given.speed, given.height}.one(
        units, "two columns of --oblique are at one speed");
    constexpr double around = 1.01;  // a table has a range
    return {std::move(encounter),
            {speed * (units.si ? units.si->speed : 1.0)},
            {std::max(speed / around, 1e-8), std::min(speed * around, 1.0)}};
  }
  const Ends ends = arguments.approach.ends(units);
  return {std::move(encounter), {ends.typed.first, ends.typed.second}, {ends.own.first, ends.own.second}};
}

Provenance describe(const TableArguments& arguments, const TableJob& job) {
  Provenance its = provenance(*arguments.command, job.encounter);
  if (!arguments.oblique) its.inputs.erase("tolerance");
  if (arguments.predicted) its.inputs["models"] = "yield, adhesion";
  its.inputs["beyond"] = arguments.beyond;
  return its;
}

std::string text_of_function(const TableArguments& arguments, TableJob& job) {
  // Half of the error is for the straight lines between the rows.
  const double share = arguments.format == "two-column" ? 0.5 : 1.0;
  const FunctionOptions options{.error = share * arguments.error,
                                .beyond = beyond(arguments),
                                .threads = arguments.threads,
                                .poll = waiting(arguments.output, "table")};
  const double slowest = job.speeds[0], fastest = job.speeds[1];  // no binding: clang 14 captures none
  const auto computed = [&] {
    if (!arguments.predicted) return restitution_function(refinable(job.encounter), slowest, fastest, options);
    auto made = predicted_function(job.encounter, slowest, fastest, options, {.work_of_adhesion = arguments.adhesion});
    job.by_models = made.by_models;
    return std::move(made.function);
  };
  const RestitutionFunction function = computed();
  if (arguments.format == "json") return as_json(arguments, job, function);
  if (is_code(arguments.format)) return code(arguments, job, function);
  return two_column(function, arguments.error, job.unit);
}

std::string text_of_pairs(const TableArguments& arguments, const TableJob& job) {
  const auto [smallest, largest] = ratios_of(arguments);
  const PairTable table = pair_table(mixture(job.encounter), job.speeds[0], job.speeds[1], smallest, largest,
                                     {.error = arguments.error,
                                      .beyond = beyond(arguments),
                                      .threads = arguments.threads,
                                      .poll = waiting(arguments.output, "table")});
  return is_code(arguments.format) ? code(arguments, job, table) : as_json(arguments, job, table);
}

/// As headers say it: rounded up to two digits.
std::string two_digits_up(double number) {
  if (!(number > 0.0)) return "0";
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1.0);
  return fmt::format("{:.2g}", std::ceil(number / unit) * unit);
}

void warn(const TableArguments& arguments, const TableJob& job) {
  const double strain = expected_strain(refinable(job.encounter).at(0), job.speeds[1]);
  if (strain > small_strain_limit) arguments.output.warn_of_strain(strain, "at the fastest");
  if (arguments.predicted) {
    arguments.output.warn(
        fmt::format("yield and adhesion are models, which differ from eps by up to {}: this and the uncertainty of "
                    "the constants (stoss predict) are not in the errors",
                    two_digits_up(job.by_models.value_or(0.0))));
    for (const std::string& line : sound_warnings(job.encounter)) arguments.output.warn(line);
    return;
  }
  warn_of_materials(arguments.output, job.encounter, job.speeds[1]);
}

void run(const TableArguments& arguments) {
  check_format(arguments);
  TableJob job = make_job(arguments);
  if (is_code(arguments.format)) validate(TableLabel{.name = arguments.name, .scale = job.unit});
  if (arguments.format == "netcdf") write_netcdf_of_rule(arguments, job);
  Output output(arguments.output.path);
  catch_interrupts();
  const std::string text = arguments.oblique         ? text_of_rule(arguments, job)
                           : arguments.ratio.empty() ? text_of_function(arguments, job)
                                                     : text_of_pairs(arguments, job);
  heed_interrupts();
  output.write(text);
  output.close();
  warn(arguments, job);
}

void add_form(CLI::App& command, TableArguments& arguments) {
  add_input(command, Question::table, "error", arguments.error, "Resolution");
  add_input(command, Question::table, "tolerance", arguments.tolerance, "Resolution");
  add_threads(command, arguments.threads);
  add_choice(command, "--format", arguments.format, {"c", "rust", "js", "two-column", "json", "netcdf"},
             "Form of the table (default: c)\n"
             "  c:          a header in C89 and C++, of plain functions\n"
             "  rust, js:   the same functions as a module\n"
             "  two-column: speed and eps, to be interpolated linearly in the speed;\n"
             "              with --oblique, at one speed: s/(MU v) and the same of s\n"
             "              after the collision, s the velocity of sliding\n"
             "  json:       computed values, slopes and errors\n"
             "  netcdf:     with --oblique: values and errors on their grid",
             "FORM", "Output");
  add(command, "--name", arguments.name, "Prefix of the names in code (default: stoss)", "NAME", "Output");
  add_choice(command, "--beyond", arguments.beyond, {"clamp", "error"},
             "What the table gives beyond its range (default: clamp)\n"
             "  clamp: the value at the nearer end, with an infinite error\n"
             "  error: not a number, with an infinite error",
             "BEYOND", "Output");
  arguments.output.add_place_to(command);
}

}  // namespace

Beyond beyond(const TableArguments& arguments) { return arguments.beyond == "clamp" ? Beyond::clamp : Beyond::error; }

TableLabel label(const TableArguments& arguments, const TableJob& job) {
  std::vector<std::string> lines;
  // The lines of CSV without the mark of a comment.
  for (const std::string& line : split(csv_header(describe(arguments, job)), '\n')) {
    lines.push_back(line.substr(std::min<std::size_t>(2, line.size())));
  }
  return {.name = arguments.name,
          .unit = job.unit_name,
          .scale = job.unit,
          .by_models = job.by_models,
          .provenance = std::move(lines)};
}

std::pair<double, double> ratios_of(const TableArguments& arguments) {
  return ends_of(input(Question::table, "ratio"), arguments.ratio, {}).own;
}

nlohmann::ordered_json json_head(const TableArguments& arguments, const TableJob& job, const std::string& between,
                                 double error) {
  auto document = json_document(describe(arguments, job));
  document["units"]["speed"] = job.unit_name;
  document["interpolation"] = "cubic Hermite in " + between;
  document["greatest_error"] = error;
  if (job.by_models) document["by_models"] = *job.by_models;
  return document;
}

void add_table(CLI::App& app) {
  auto& arguments = add_subcommand<TableArguments>(
      app, "table", "Coefficient of restitution as a function, for other programs", run,
      "Examples:\n"
      "  stoss table --body disk --poisson 0.33 --speed 1e-4:0.3 -o restitution.h\n"
      "  stoss table --body sphere --poisson 0.3 --speed 1e-5:0.1 --against same --error 1e-4 --format json\n"
      "  stoss table --body sphere --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.005 --speed 0.01:10\n"
      "      --against half-space,poisson=0.23,young=7e10,density=2500 --format two-column -o steel_on_glass.txt\n"
      "  stoss table --body disk --poisson 0.33 --speed 1e-4:0.3 --against same --ratio 1:3 -o pairs.h\n"
      "  stoss table --body sphere --poisson 0.3 --speed 1e-4:1e-2 --against same --oblique -o rule.h\n"
      "  stoss table --body rod --speed 0.001:0.1 --against rod,length=2.5 --error 0.01 --name rods -o rods.h");
  CLI::App& command = *arguments.command;
  arguments.who.first.add_poisson_to(command);
  arguments.approach.add_to(command, Question::table, "Motion");
  add_input(command, Question::table, "ratio", arguments.ratio, "Body");
  command
      .add_flag("--oblique", arguments.oblique,
                "The whole collision rule: what becomes of the velocity along the surface\n"
                "and of the spins too, at any angle")
      ->group("Body");
  command
      .add_flag("--predict", arguments.predicted,
                "eps of real balls, with yield and adhesion as models (stoss predict)")
      ->group("Body");
  arguments.who.add_to(command);
  add_input(command, Question::table, "adhesion", arguments.adhesion, "Against");
  add_input(command, Question::table, "friction", arguments.friction, "Against");
  add_form(command, arguments);
}

}  // namespace stoss::cli
