// stoss impact: one collision at a fixed resolution.
#include "stoss/impact/impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "arguments.hpp"
#include "encounter.hpp"
#include "options.hpp"
#include "stoss/errors.hpp"
#include "tables.hpp"
#include "trajectory.hpp"
#include "vibration_arguments.hpp"
#include "yield.hpp"

namespace stoss::cli {
namespace {

struct ImpactArguments {
  EncounterOptions who;
  VibrationArguments vibration;
  std::string speed;
  std::string tail = "radiating";
  double cutoff = 50.0;
  Resolution resolution;
  std::string trajectory;
  int every = 1;
  OutputArguments output;
  CLI::Option* tail_option = nullptr;
  CLI::Option* every_option = nullptr;
};

Provenance describe(const ImpactArguments& arguments, const Encounter& encounter) {
  Provenance provenance{"impact", command_line(), {}};
  cli::describe(encounter, provenance.inputs);
  arguments.vibration.describe(provenance.inputs);
  if (!is_soft(encounter)) provenance.inputs["tail"] = arguments.tail;
  return provenance;
}

Record make_record(const Impact& impact, const Encounter& encounter) {
  const Units units = units_of(encounter);
  Record record;
  if (!is_rod(encounter)) record.push_back({"poisson", "", poisson_of(first_solid(encounter))});
  record.push_back({"speed", units.own_name(Dimension::speed), impact.speed});
  if (units.si) record.push_back({"speed_si", "m/s", impact.speed * units.si->speed});
  add_quantities(record, impact_table(), impact, units);
  add_yield(record, units, yield_speed(encounter), impact.speed);
  return record;
}

/// @param pair     whether modes of two bodies are told apart
/// @param vibrates whether modes have energy before the impact
void write_table(Output output, const Record& record, std::vector<ModeEnergy> modes, bool pair, bool vibrates) {
  for (const Entry& entry : record) {
    const auto* number = std::get_if<double>(&entry.value);
    const std::string value = number != nullptr
                                  ? fmt::format("{:.8g}", *number)
                                  : std::visit([](const auto& v) { return fmt::format("{}", v); }, entry.value);
    const std::string unit = entry.unit.empty() ? "" : "  " + entry.unit;
    output.write(fmt::format("{:<22}{:>16}{}\n", entry.key, value, unit));
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

void run(const ImpactArguments& arguments) {
  const Encounter encounter = arguments.who.encounter();
  if (is_soft(encounter) && arguments.tail_option->count() > 0) {
    throw InvalidInput(
        "tail: got a tail with --against exponential, allowed only without (the soft wall leaves it out)");
  }
  if (!arguments.trajectory.empty() && same_output(arguments.trajectory, arguments.output.path)) {
    throw InvalidInput(
        "trajectory: got the file of --output or stdout, allowed another one (one would overwrite the other)");
  }
  if (arguments.every < 1) {
    throw InvalidInput(
        fmt::format("every: got {}, allowed 1 or more (steps between two rows of the trajectory)", arguments.every));
  }
  if (arguments.every_option->count() > 0 && arguments.trajectory.empty()) {
    throw InvalidInput("every: got --every without --trajectory, allowed only with it (it thins out its rows)");
  }
  const std::vector<double> speeds = parse_speeds(arguments.speed, units_of(encounter).si);
  if (speeds.size() != 1) {
    throw InvalidInput(fmt::format("speed: got {} speeds, allowed one (stoss restitution takes lists)", speeds.size()));
  }
  ImpactOptions options{.resolution = arguments.resolution};
  options.resolution.tail = arguments.tail == "static" ? Tail::quasistatic : Tail::radiating;
  const Contact contact = contact_of(encounter, arguments.cutoff, speeds[0]);
  const Vibration vibration = arguments.vibration.vibration();
  if (!vibration.empty()) options.start = approach(contact, speeds[0], vibration);
  const Provenance provenance = describe(arguments, encounter);
  Output output(arguments.output.path);

  Impact result;
  if (arguments.trajectory.empty()) {
    result = impact(contact, speeds[0], options);
  } else {
    Provenance made = provenance;
    made.schema = "trajectory";
    made.inputs["speed"] = speeds[0];
    made.inputs["cutoff"] = arguments.cutoff;
    Trajectory trajectory(arguments.trajectory, made, units_of(encounter));
    const ImpactObserver observer = [&](const Snapshot& now) { trajectory.write(now); };
    result = impact(contact, speeds[0], options, {.observer = observer, .every = arguments.every});
    trajectory.finish();
  }
  if (result.beyond_small_strain) {
    arguments.output.warn("speed above 0.5 c or compression above 0.5 R: linear elasticity has lost its meaning here");
  }
  const auto yield = yield_speed(encounter);
  if (yield && result.speed * units_of(encounter).si->speed > *yield) arguments.output.warn(yield_warning(*yield));

  const Record record = make_record(result, encounter);
  if (arguments.output.chosen_format() == Format::table) {
    const bool unbounded = meets_unbounded(encounter);
    std::vector<ModeEnergy> modes = result.energy.modes;
    // The waves of a half-space are a continuum: single ones say little.
    if (unbounded) std::erase_if(modes, [](const ModeEnergy& mode) { return mode.body == 1; });
    write_table(std::move(output), record, std::move(modes), meets_body(encounter) && !unbounded, !vibration.empty());
    return;
  }
  Report report(std::move(output), arguments.output.chosen_format(), provenance);
  report.add(record);
  if (arguments.output.chosen_format() == Format::json)
    report.attach("modes", to_json(mode_energy_table(), result.energy.modes));
  report.finish();
}

}  // namespace

void add_impact(CLI::App& app) {
  auto* command = app.add_subcommand("impact", "One impact at a fixed resolution, with its energy ledger");
  auto arguments = std::make_shared<ImpactArguments>();
  arguments->who.first.add_poisson_to(*command);
  command
      ->add_option("--speed", arguments->speed, "Speed of approach, 1e-8 to 1 in c of the body (with a material: m/s)")
      ->required()
      ->type_name("V")
      ->group("Body");
  arguments->who.add_to(*command, true);
  arguments->vibration.add_to(*command);
  arguments->tail_option =
      command->add_option("--tail", arguments->tail, "How modes above the cutoff answer (default: radiating)")
          ->check(CLI::IsMember({"radiating", "static"}))
          ->type_name("TAIL")
          ->group("Against");
  add_number(*command, "--cutoff", arguments->cutoff, "Modes up to this frequency in c/R are kept (default: 50)")
      ->type_name("OMEGA")
      ->group("Resolution");
  add_number(*command, "--step", arguments->resolution.step, "Time step in R/c (default: recommended)")
      ->type_name("DT")
      ->group("Resolution");
  add_integer(*command, "--nodes", arguments->resolution.nodes, "Contact nodes, 16 to 4096 (default: recommended)")
      ->type_name("N")
      ->group("Resolution");
  command->add_option("--trajectory", arguments->trajectory, "Write time, center, force, energies as CSV to FILE")
      ->type_name("FILE")
      ->group("Output");
  arguments->every_option =
      add_integer(*command, "--every", arguments->every, "Trajectory: every so many steps (default: 1)")
          ->type_name("K")
          ->group("Output");
  arguments->output.add_to(*command);
  command->footer(
      "Examples:\n"
      "  stoss impact --poisson 0.33 --speed 0.1 --trajectory t.csv --every 4\n"
      "  stoss impact --poisson 0.33 --speed 0.2 --against disk,radius=2\n"
      "  stoss impact --poisson 0.33 --speed 0.1 --against exponential,hardness=300\n"
      "  stoss impact --body sphere --poisson 0.3 --speed 0.1 --against sphere,radius=2,young=4\n"
      "  stoss impact --body sphere --poisson 0.3 --speed 0.1 --against half-space --cutoff 12\n"
      "  stoss impact --body sphere --poisson 0.3 --speed 0.01 --mode 2,0,energy=0.1,phase=2");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace stoss::cli
