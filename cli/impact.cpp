// stoss impact: one collision at a fixed resolution.
#include "stoss/impact/impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "arguments.hpp"
#include "options.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/errors.hpp"
#include "trajectory.hpp"

namespace stoss::cli {
namespace {

struct ImpactArguments {
  DiskArguments disk;
  std::string speed;
  std::string wall = "hard";
  std::string tail = "radiating";
  ExponentialWall soft;
  double cutoff = 50.0;
  ImpactOptions options;
  std::string trajectory;
  OutputArguments output;
  CLI::Option* hardness_option = nullptr;
  CLI::Option* strength_option = nullptr;
  CLI::Option* tail_option = nullptr;

  [[nodiscard]] bool soft_given() const { return hardness_option->count() + strength_option->count() > 0; }
};

Provenance describe(const ImpactArguments& arguments) {
  Provenance provenance{"impact", command_line(), {}};
  arguments.disk.describe(provenance.inputs);
  if (arguments.wall == "hard") {
    provenance.inputs["wall"] = "hard";
    provenance.inputs["tail"] = arguments.tail;
  } else {
    provenance.inputs["wall"] = "exponential";
    provenance.inputs["hardness"] = arguments.soft.hardness;
    provenance.inputs["strength"] = arguments.soft.strength;
  }
  return provenance;
}

std::vector<Entry> entries(const Impact& impact, double poisson, const std::optional<Scales>& si) {
  std::vector<Entry> list{
      {"poisson", "", poisson},
      {"speed", "c", impact.speed},
      {"restitution", "", impact.restitution},
      {"lost_fraction", "", impact.lost_fraction},
      {"translation", "", impact.energy.translation},
      {"vibration", "", impact.energy.vibration},
      {"unresolved", "", impact.energy.unresolved},
      {"contact_time", "R/c", impact.contact_time},
      {"contacts", "", static_cast<long>(impact.contacts)},
      {"max_force", "piRE", impact.max_force},
      {"max_compression", "R", impact.max_compression},
      {"max_half_width", "R", impact.max_half_width},
      {"cutoff", "c/R", impact.cutoff},
      {"modes", "", static_cast<long>(impact.energy.modes.size())},
      {"step", "R/c", impact.step},
      {"nodes", "", static_cast<long>(impact.nodes)},
      {"steps", "", impact.steps},
      {"energy_error", "", impact.energy_error},
      {"momentum_error", "", impact.momentum_error},
      {"beyond_small_strain", "", impact.beyond_small_strain},
  };
  if (si) {
    list.push_back({"speed_si", "m/s", impact.speed * si->speed});
    list.push_back({"contact_time_si", "s", impact.contact_time * si->time});
    list.push_back({"max_force_si", "N/m", impact.max_force * si->force});
    list.push_back({"max_compression_si", "m", impact.max_compression * si->length});
  }
  return list;
}

void write_table(const std::string& path, const std::vector<Entry>& list, std::vector<ModeEnergy> modes) {
  Output output(path);
  output.keep(0);
  for (const Entry& entry : list) {
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
  output.write("\nmost energetic modes (shares of the initial energy)\n");
  output.write(fmt::format("{:>5}{:>5}{:>12}{:>14}{:>14}\n", "n", "l", "omega", "average", "after"));
  for (std::size_t i = 0; i < count; ++i) {
    const ModeEnergy& mode = modes[i];
    output.write(fmt::format("{:>5}{:>5}{:>12.6f}{:>14.7f}{:>14.7f}\n", mode.order, mode.index, mode.omega,
                             mode.average, mode.after));
  }
  output.close();
}

nlohmann::ordered_json to_json(const std::vector<ModeEnergy>& modes) {
  auto list = nlohmann::ordered_json::array();
  for (const ModeEnergy& mode : modes) {
    list.push_back({{"order", mode.order},
                    {"index", mode.index},
                    {"omega", mode.omega},
                    {"average", mode.average},
                    {"after", mode.after}});
  }
  return list;
}

void run(const ImpactArguments& arguments) {
  if (arguments.wall == "hard" && arguments.soft_given()) {
    throw InvalidInput("wall: got hard with --hardness or --strength, allowed exponential (add --wall exponential)");
  }
  if (arguments.wall == "exponential" && arguments.tail_option->count() > 0) {
    throw InvalidInput(
        "tail: got a tail with --wall exponential, allowed only with --wall hard (the soft wall leaves it out)");
  }
  if (!arguments.trajectory.empty() && same_output(arguments.trajectory, arguments.output.path)) {
    throw InvalidInput(
        "trajectory: got the file of --output or stdout, allowed another one (one would overwrite the other)");
  }
  if (arguments.options.observe_every < 1) {
    throw InvalidInput(fmt::format("every: got {}, allowed 1 or more (steps between two rows of the trajectory)",
                                   arguments.options.observe_every));
  }
  const auto si = arguments.disk.si();
  const std::vector<double> speeds = parse_speeds(arguments.speed, si);
  if (speeds.size() != 1) {
    throw InvalidInput(fmt::format("speed: got {} speeds, allowed one (stoss restitution takes lists)", speeds.size()));
  }
  const double poisson = arguments.disk.plane_poisson();
  ImpactOptions options = arguments.options;
  options.tail = arguments.tail == "static" ? Tail::quasistatic : Tail::radiating;
  const Wall wall = arguments.wall == "hard" ? Wall(HardWall{}) : Wall(arguments.soft);
  const Body body = disk(poisson, arguments.cutoff);
  const Provenance provenance = describe(arguments);

  Impact result;
  if (arguments.trajectory.empty()) {
    result = impact(body, wall, speeds[0], options);
  } else {
    Provenance made = provenance;
    made.schema = "trajectory";
    made.inputs["speed"] = speeds[0];
    made.inputs["cutoff"] = arguments.cutoff;
    Trajectory trajectory(arguments.trajectory, made);
    result = impact(body, wall, speeds[0], options, [&](const Snapshot& now) { trajectory.write(now); });
    trajectory.finish();
  }
  if (result.beyond_small_strain) {
    arguments.output.warn("speed above 0.5 c or compression above 0.5 R: linear elasticity has lost its meaning here");
  }

  const std::vector<Entry> list = entries(result, poisson, si);
  if (arguments.output.chosen_format() == Format::table) {
    write_table(arguments.output.path, list, result.energy.modes);
    return;
  }
  Report report(Output(arguments.output.path), arguments.output.chosen_format(), provenance);
  report.add(list);
  if (arguments.output.chosen_format() == Format::json) report.attach("modes", to_json(result.energy.modes));
  report.finish();
}

}  // namespace

void add_impact(CLI::App& app) {
  auto* command = app.add_subcommand("impact", "One impact of a disk at a fixed resolution, with its energy ledger");
  auto arguments = std::make_shared<ImpactArguments>();
  arguments->disk.add_to(*command);
  command->add_option("--speed", arguments->speed, "Speed towards the wall, 1e-8 to 1 in c (with a material: m/s)")
      ->required()
      ->type_name("V")
      ->group("Body");
  command->add_option("--wall", arguments->wall, "Kind of wall (default: hard)")
      ->check(CLI::IsMember({"hard", "exponential"}))
      ->type_name("WALL")
      ->group("Wall");
  arguments->hardness_option = add_number(*command, "--hardness", arguments->soft.hardness,
                                          "alpha R of the exponential wall, 1 to 1e6 (default: 500)")
                                   ->type_name("ALPHA")
                                   ->group("Wall");
  arguments->strength_option = add_number(*command, "--strength", arguments->soft.strength,
                                          "V0 of the exponential wall in rho c^2 R^2; shifts it (default: 1)")
                                   ->type_name("V0")
                                   ->group("Wall");
  arguments->tail_option =
      command
          ->add_option("--tail", arguments->tail, "How modes above the cutoff answer a hard wall (default: radiating)")
          ->check(CLI::IsMember({"radiating", "static"}))
          ->type_name("TAIL")
          ->group("Wall");
  add_number(*command, "--cutoff", arguments->cutoff, "Modes up to this frequency in c/R are kept (default: 50)")
      ->type_name("OMEGA")
      ->group("Resolution");
  add_number(*command, "--step", arguments->options.step, "Time step in R/c (default: chosen for the wall)")
      ->type_name("DT")
      ->group("Resolution");
  add_integer(*command, "--nodes", arguments->options.nodes, "Contact nodes, 16 to 4096 (default: chosen for the wall)")
      ->type_name("N")
      ->group("Resolution");
  command->add_option("--trajectory", arguments->trajectory, "Write time, center, force, energies as CSV to FILE")
      ->type_name("FILE")
      ->group("Output");
  add_integer(*command, "--every", arguments->options.observe_every, "Trajectory: every so many steps (default: 1)")
      ->type_name("K")
      ->group("Output");
  arguments->output.add_to(*command);
  command->footer(
      "Example:\n  stoss impact --poisson 0.33 --speed 0.1 --trajectory t.csv --every 4\n"
      "Two equal disks that each move at V towards each other are the same problem.");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace stoss::cli
