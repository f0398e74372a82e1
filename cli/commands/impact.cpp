// stoss impact: one collision at a fixed resolution.
#include "stoss/impact/impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/output_options.hpp"
#include "process/process.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/quantities.hpp"

namespace stoss::cli {
namespace {

struct ImpactArguments {
  EncounterOptions who;
  ApproachOptions approach;
  KeptOptions kept;
  Resolution resolution;
  std::string trajectory;
  int every = 1;
  OutputOptions output;
  CLI::App* command = nullptr;
};

/// The one row of the result, and its columns.
std::pair<Columns, Row> make_row(const Impact& impact, const Encounter& encounter) {
  const Units units = units_of(encounter);
  Quantities<Impact> quantities = impact_quantities();
  std::erase_if(quantities, [](const auto& quantity) { return quantity.name == "half_width"; });
  const Fields<Impact> fields(quantities, units, {{"cutoff", {.in_si = false}}, {"step", {.in_si = false}}});
  const Yielding yielding = cli::yielding(encounter);
  Columns columns;
  Row row;
  if (const auto poisson = poisson_of(encounter)) {
    columns.push_back({"poisson"});
    row.emplace_back(*poisson);
  }
  append(columns, speed_columns(units), fields.columns(), yielding.columns());
  append(row, speed_row(units, impact.speed), fields.row(impact), yielding.row(impact.speed));
  return {columns, row};
}

/// @param pair     whether modes of two bodies are told apart
/// @param vibrates whether modes have energy before the impact
void write_table(Output output, const Columns& columns, const Row& row, std::vector<ModeEnergy> modes, bool pair,
                 bool vibrates) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto* number = std::get_if<double>(&row[i]);
    const std::string value = number != nullptr ? fmt::format("{:.8g}", *number) : full_precision(row[i]);
    const std::string unit = columns[i].unit.empty() ? "" : "  " + columns[i].unit;
    output.write(fmt::format("{:<22}{:>16}{}\n", columns[i].name, value, unit));
  }
  constexpr std::size_t shown = 10;
  const std::size_t count = std::min(shown, modes.size());
  std::partial_sort(modes.begin(), modes.begin() + static_cast<std::ptrdiff_t>(count), modes.end(),
                    [](const ModeEnergy& a, const ModeEnergy& b) { return a.average > b.average; });
  if (count == 0) return output.close();
  output.write("\nmost energetic modes (shares of the initial energy)\n");
  const auto body = [&](const std::string& text) { return pair ? fmt::format("{:>8}", text) : ""; };
  const auto before = [&](const std::string& text) { return vibrates ? fmt::format("{:>14}", text) : ""; };
  output.write(fmt::format("{}{:>5}{:>5}{:>12}{}{:>14}{:>14}\n", body("body"), "n", "l", "omega", before("before"),
                           "average", "after"));
  for (std::size_t i = 0; i < count; ++i) {
    const ModeEnergy& mode = modes[i];
    output.write(fmt::format("{}{:>5}{:>5}{:>12.6f}{}{:>14.7f}{:>14.7f}\n", body(mode.body == 0 ? "first" : "second"),
                             mode.order, mode.index, mode.omega, before(fmt::format("{:.7f}", mode.before)),
                             mode.average, mode.after));
  }
  output.close();
}

void check_trajectory(const ImpactArguments& arguments) {
  if (!arguments.trajectory.empty() && same_output(arguments.trajectory, arguments.output.path)) {
    throw InvalidInput::out_of_range("trajectory", "the file of --output or stdout", "another one",
                                     "one would overwrite the other");
  }
  if (arguments.every < 1) {
    throw InvalidInput::out_of_range("every", fmt::format("{}", arguments.every), "1 or more",
                                     "steps between two rows of the trajectory");
  }
  if (given(*arguments.command, "--every") && arguments.trajectory.empty()) {
    throw InvalidInput::out_of_range("every", "--every without --trajectory", "only with it", "it thins out its rows");
  }
}

/// The impact, with its instants as CSV if they are asked for. A refused impact leaves their file alone.
Impact compute(const ImpactArguments& arguments, const Encounter& encounter, const Contact& contact, double speed,
               const ImpactOptions& options) {
  if (arguments.trajectory.empty()) return impact(contact, speed, options);
  Provenance provenance = arguments.kept.provenance(*arguments.command, encounter);
  provenance.schema = "trajectory";
  provenance.inputs["speed"] = speed;
  const Fields<Snapshot> fields(snapshot_quantities(), units_of(encounter));
  Writer writer(Output(arguments.trajectory), Format::csv, provenance, fields.columns());
  Impact result;
  writer.finish_after([&] {
    const ImpactObserver observer = [&](const Snapshot& now) {
      heed_interrupts();
      writer.add(fields.row(now));
    };
    result = impact(contact, speed, options, {.observer = observer, .every = arguments.every});
  });
  return result;
}

void run(const ImpactArguments& asked_for) {
  ImpactArguments arguments = asked_for;
  const Encounter encounter = arguments.who.encounter();
  KeptOptions& kept = arguments.kept;
  arguments.resolution.tail = kept.tail();
  check_trajectory(arguments);
  const double speed = arguments.approach.one(units_of(encounter), "stoss restitution takes lists");
  catch_interrupts();
  ImpactOptions options{.resolution = arguments.resolution, .poll = waiting(arguments.output, "impact")};
  const OutputOptions& asked = arguments.output;
  Output output(asked.path);
  kept.choose(*arguments.command, encounter, speed, 50.0, options.poll);
  const Contact contact = contact_of(encounter, kept.cutoff, speed, options.poll);
  const Vibration& vibration = encounter.vibration;
  if (!vibration.empty()) options.start = approach(contact, speed, vibration);
  const Impact result = compute(arguments, encounter, contact, speed, options);
  if (result.remaining > 0.0) asked.warn(note_of_staying());
  if (result.beyond_small_strain) asked.warn_of_strain(result.strain, "here");
  warn_of_materials(asked, encounter, result.speed);

  const auto [columns, row] = make_row(result, encounter);
  if (asked.chosen_format() == Format::table) {
    const Kind& against = kind(encounter.against.kind);
    const bool unbounded = !against.wall && !against.bounded;
    std::vector<ModeEnergy> modes = result.energy.modes;
    // The waves of a half-space are a continuum: single ones say little.
    if (unbounded) std::erase_if(modes, [](const ModeEnergy& mode) { return mode.body == 1; });
    const bool pair = against.name == "same" || (!against.wall && !unbounded);
    return write_table(std::move(output), columns, row, std::move(modes), pair, !vibration.empty());
  }
  Writer writer(std::move(output), asked.chosen_format(), kept.provenance(*arguments.command, encounter), columns);
  writer.add(row);
  if (asked.chosen_format() == Format::json) {
    writer.attach("modes", to_json(mode_energy_quantities(), result.energy.modes));
  }
  writer.finish();
}

}  // namespace

void add_impact(CLI::App& app) {
  auto& arguments = add_subcommand<ImpactArguments>(
      app, "impact", "One impact at a fixed resolution, with its energy ledger", run,
      "Examples:\n"
      "  stoss impact --body disk --poisson 0.33 --speed 0.1 --trajectory t.csv --every 4\n"
      "  stoss impact --body disk --poisson 0.33 --speed 0.2 --against disk,radius=2\n"
      "  stoss impact --body disk --poisson 0.33 --speed 0.1 --against exponential,hardness=300\n"
      "  stoss impact --body sphere --poisson 0.3 --speed 0.1 --against sphere,radius=2,young=4\n"
      "  stoss impact --body sphere --poisson 0.3 --speed 0.1 --against half-space --cutoff 12\n"
      "  stoss impact --body sphere --poisson 0.3 --speed 0.01 --mode 2,0,energy=0.1,phase=2");
  CLI::App& command = *arguments.command;
  arguments.who.first.add_poisson_to(command);
  arguments.approach.add_to(command, Question::impact, "Motion");
  arguments.who.add_to(command);
  add_modes_to(command, arguments.who.modes);
  arguments.kept.add_to(command, Question::impact);
  add_input(command, Question::impact, "step", arguments.resolution.step, "Resolution");
  add_input(command, Question::impact, "nodes", arguments.resolution.nodes, "Resolution");
  add(command, "--trajectory", arguments.trajectory,
      "Write time, center, force, energies as CSV to FILE, with a material in SI too", "FILE", "Output");
  add(command, "--every", arguments.every, "With --trajectory: write every K-th step (default: 1)", "K", "Output");
  arguments.output.add_to(command);
}

}  // namespace stoss::cli
