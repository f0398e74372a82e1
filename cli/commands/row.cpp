// stoss row: bodies on one line, as in a cradle.
#include <fmt/format.h>

#include <algorithm>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/output_options.hpp"
#include "process/process.hpp"
#include "stoss/encounter/row.hpp"
#include "stoss/errors.hpp"
#include "stoss/row/quantities.hpp"

namespace stoss::cli {
namespace {

struct RowArguments {
  EncounterOptions who{.first = {}, .against = ""};
  std::string document, gap, before;
  ApproachOptions approach;
  std::vector<std::string> modes;
  int count = 3;
  std::optional<double> until;
  double tolerance = 1e-3;
  OutputOptions output;
  CLI::App* command = nullptr;
};

/// The row of a document.
GivenRow row_of_file(const RowArguments& arguments) {
  for (const char* each : {"--body", "--count", "--against", "--before", "--gap", "--mode"}) {
    if (!given(*arguments.command, each)) continue;
    throw InvalidInput::conflict("bodies", fmt::format("{} beside a document", each),
                                 "the document has all but the speeds");
  }
  const std::string& path = arguments.document;
  return row_from_json(text_of_file("bodies", names_file(path) ? path.substr(1) : path, "a document of a row"));
}

std::vector<double> gaps_of(const RowArguments& arguments, const GivenRow& row, const Units& units) {
  if (arguments.gap.empty()) return {};
  std::vector<double> gaps = series_of(input(Question::row, "gap"), arguments.gap, units);
  const std::size_t wanted = row.bodies.size() - 1 + (row.wall_before ? 1 : 0) + (row.after ? 1 : 0);
  if (gaps.size() == 1) gaps.resize(wanted, gaps.front());
  if (units.si) {
    for (double& each : gaps) each *= units.si->length;
  }
  return gaps;
}

GivenRow row_of(const RowArguments& arguments) {
  if (!arguments.document.empty()) return row_of_file(arguments);
  EncounterOptions who = arguments.who;
  who.against = who.against.empty() ? "wall" : who.against;
  const Encounter encounter = who.encounter();
  require(input(Question::row, "count"), arguments.count, std::nullopt, {});
  GivenRow row;
  row.bodies.assign(static_cast<std::size_t>(arguments.count), encounter.first);
  row.wall_before = !arguments.before.empty();
  if (!arguments.who.against.empty()) row.after = encounter.against;
  row.vibration = vibration_of_row(arguments.modes);
  row.gaps = gaps_of(arguments, row, units_of(encounter));
  return row;
}

nlohmann::ordered_json details_of(const std::vector<RowBody>& bodies, const RowResult& result, double unit,
                                  const std::string& unit_of_speeds) {
  nlohmann::ordered_json details{{"velocities", nlohmann::ordered_json::array()},
                                 {"velocities_after", nlohmann::ordered_json::array()},
                                 {"velocities_after_error", nlohmann::ordered_json::array()}};
  for (const RowBody& each : bodies) {
    details["velocities"].push_back(each.velocity * unit);
    details["velocities_after"].push_back(each.velocity_after.value * unit);
    details["velocities_after_error"].push_back(each.velocity_after.error * unit);
  }
  details["velocity_unit"] = unit_of_speeds;
  details["contacts"] = to_json(row_contact_quantities(), result.finest.contacts);
  return details;
}

void write(const RowArguments& arguments, const GivenRow& row, const std::vector<RowBody>& bodies,
           const RowResult& result) {
  const Encounter first = first_of(row);
  const Units units = units_of(first);
  Provenance its = provenance(*arguments.command, first);
  its.inputs.erase("first"), its.inputs.erase("against");
  its.inputs["row"] = nlohmann::ordered_json::parse(to_json(row));
  if (arguments.output.chosen_format() == Format::json) {
    const Fields<RowResult> fields(row_quantities(), units);
    Writer writer = arguments.output.writer(its, fields.columns());
    writer.add(fields.row(result), details_of(bodies, result, speed_unit(first), units.si ? "m/s" : "c"));
    return writer.finish();
  }
  const Fields<RowBody> fields(row_body_quantities(), units,
                               {{"number", {.width = 8}},
                                {"velocity", {.width = 14, .si_width = 14}},
                                {"velocity_after", {.width = 26, .si_width = 16, .with_error = true}}});
  Writer writer = arguments.output.writer(its, fields.columns());
  for (const RowBody& each : bodies) writer.add(fields.row(each));
  if (arguments.output.chosen_format() == Format::table) {
    writer.close_table(fmt::format("\n{:.6g} of the energy stays in translation, {:.2g} goes into vibration\n",
                                   result.translation.value, result.finest.energy.vibration));
  }
  writer.finish();
}

void run(const RowArguments& arguments) {
  const GivenRow row = row_of(arguments);
  const Encounter first = first_of(row);
  std::vector<double> speeds = arguments.approach.series(units_of(first));
  for (double& each : speeds) each *= speed_unit(first);
  const std::vector<double> own = speeds_in_c(row, speeds);
  catch_interrupts();
  stoss::RowOptions options{.tolerance = arguments.tolerance, .poll = waiting(arguments.output, "computes the row")};
  if (arguments.until) options.until = own_value(input(Question::row, "until"), *arguments.until, units_of(first));
  const RowResult result = stoss::row(row, speeds, options);
  std::vector<RowBody> bodies;
  for (std::size_t b = 0; b < row.bodies.size(); ++b) {
    bodies.push_back({static_cast<int>(b), own[b], result.velocities_after[b]});
  }
  write(arguments, row, bodies, result);
  const OutputOptions& output = arguments.output;
  if (result.finest.strain > small_strain_limit) output.warn_of_strain(result.finest.strain);
  std::vector<double> work;
  for (const RowContact& each : result.finest.contacts) work.push_back(each.max_force * each.max_compression);
  for (const std::string& line : material_warnings(row, work)) output.warn(line);
  if (result.converged) return;
  output.warn(fmt::format("velocities not as accurate as asked for: {}", result.reason));
  throw NotAsAsked{};
}

}  // namespace

void add_row(CLI::App& app) {
  auto& arguments = add_subcommand<RowArguments>(
      app, "row", "Velocities of bodies on one line after all their contacts, as in a cradle", run,
      "Examples:\n"
      "  stoss row --body sphere --poisson 0.3 --count 3 --speed 0.1\n"
      "  stoss row --body sphere --material 'bearing steel' --radius 0.01 --count 5 --speed 0.5,0.5\n"
      "  stoss row --body disk --poisson 0.3 --count 2 --speed 0.01,0.01 --against wall --gap 0.001\n"
      "  stoss row --body sphere --material rubber --radius 0.02 --count 2 --height 1,1 --against wall\n"
      "  stoss row --bodies balls.json --speed 1 --format json");
  CLI::App& command = *arguments.command;
  arguments.who.first.add_poisson_to(command);
  arguments.approach.add_to(command, Question::row, "Motion");
  arguments.who.add_to(command, "\nHere it stands on the right of the row (default: nothing)");
  add_modes_of_row_to(command, arguments.modes);
  const char* const group = "Row";
  add_input(command, Question::row, "count", arguments.count, group);
  add_input(command, Question::row, "gap", arguments.gap, group);
  add_choice(command, "--before", arguments.before, {"wall"}, "What stands on the left of the row (default: nothing)",
             "WHAT", group);
  add(command, "--bodies", arguments.document,
      "A JSON document with bodies of their own and what stands at their ends,\nin place of all of these", "FILE",
      group);
  add_input(command, Question::row, "until", arguments.until, "Motion");
  add_input(command, Question::row, "tolerance", arguments.tolerance, "Resolution");
  arguments.output.add_to(command);
}

}  // namespace stoss::cli
