// stoss bounce: one body that comes back to what it meets, again and again.
#include "stoss/vibration/bounce.hpp"

#include <fmt/format.h>

#include <memory>

#include "arguments.hpp"
#include "encounter.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#include "stoss/errors.hpp"
#include "tables.hpp"
#include "vibration_arguments.hpp"
#include "yield.hpp"

namespace stoss::cli {
namespace {

struct BounceArguments {
  EncounterOptions who;
  VibrationArguments vibration;
  std::string speed;
  int count = 100;
  std::optional<double> flight_time, gravity, decay_time;
  std::string tail = "radiating";
  double cutoff = 20.0;
  OutputArguments output;
  CLI::Option* tail_option = nullptr;
};

/// As the core takes them; with a material they are in s and m/s².
BounceOptions make_options(const BounceArguments& arguments, const Units& units) {
  const auto in = [](const std::optional<double>& value, double unit) {
    return value ? std::optional(*value / unit) : std::nullopt;
  };
  const double time = units.si ? units.si->time : 1.0, acceleration = units.si ? units.si->speed / time : 1.0;
  return {.count = arguments.count,
          .flight_time = in(arguments.flight_time, time),
          .gravity = in(arguments.gravity, acceleration),
          .decay_time = in(arguments.decay_time, time),
          .resolution = {.tail = arguments.tail == "static" ? Tail::quasistatic : Tail::radiating},
          .vibration = arguments.vibration.vibration(),
          .poll = heed_interrupts};
}

Provenance describe(const BounceArguments& arguments, const Encounter& encounter, double speed) {
  Provenance provenance{"bounce", command_line(), {}};
  auto& inputs = provenance.inputs;
  const bool si = units_of(encounter).si.has_value();
  cli::describe(encounter, inputs);
  if (!si && !is_rod(encounter)) inputs["poisson"] = poisson_of(first_solid(encounter));
  inputs["speed"] = speed;
  arguments.vibration.describe(inputs);
  if (arguments.flight_time) inputs[si ? "flight_time[s]" : "flight_time"] = *arguments.flight_time;
  if (arguments.gravity) inputs[si ? "gravity[m/s^2]" : "gravity"] = *arguments.gravity;
  if (arguments.decay_time) inputs[si ? "decay_time[s]" : "decay_time"] = *arguments.decay_time;
  inputs["cutoff"] = arguments.cutoff;
  if (!is_soft(encounter)) inputs["tail"] = arguments.tail;
  return provenance;
}

/// What is to be said of a sequence at its end.
void warn(const OutputArguments& output, long short_flights, bool beyond_small_strain) {
  if (beyond_small_strain) {
    output.warn("speed above 0.5 c or compression above 0.5 R: linear elasticity has lost its meaning there");
  }
  if (short_flights > 0) {
    output.warn(
        fmt::format("{} flights too short for the vibration to keep clear of the wall (short_flight)", short_flights));
  }
}

void run(const BounceArguments& arguments) {
  const Encounter encounter = arguments.who.encounter();
  if (is_soft(encounter) && arguments.tail_option->count() > 0) {
    throw InvalidInput(
        "tail: got a tail with --against exponential, allowed only without (the soft wall leaves it out)");
  }
  const Units units = units_of(encounter);
  const std::vector<double> speeds = parse_speeds(arguments.speed, units.si);
  if (speeds.size() != 1) {
    throw InvalidInput(fmt::format("speed: got {} speeds, allowed one (that of the first impact)", speeds.size()));
  }
  const double first = speeds.front();
  const Contact contact = contact_of(encounter, arguments.cutoff, slowest_bounce(first));
  const BounceOptions options = make_options(arguments, units);
  validate(contact, first, options);

  const auto yield = yield_speed(encounter);
  bool beyond_yield = false, beyond_small_strain = false;
  long short_flights = 0;
  catch_interrupts();
  Report report(Output(arguments.output.path, Output::Use::rows), arguments.output.chosen_format(),
                describe(arguments, encounter, first));
  report.finish_after([&] {
    bounce(contact, first, options, [&](const Bounce& bounce, const Impact&) {
      Record record;
      add_quantities(record, bounce_table(), bounce, units);
      add_yield(record, units, yield, bounce.speed);
      report.add(record);
      beyond_yield = beyond_yield || (yield && bounce.speed * units.si->speed > *yield);
      beyond_small_strain = beyond_small_strain || bounce.beyond_small_strain;
      short_flights += bounce.short_flight ? 1 : 0;
    });
  });
  warn(arguments.output, short_flights, beyond_small_strain);
  if (beyond_yield) arguments.output.warn(yield_warning(*yield));
}

void add_flight(CLI::App& command, BounceArguments& arguments) {
  const std::string group = "Flight (one of flight-time, gravity)";
  add_integer(command, "--count", arguments.count, "Impacts, 1 or more (default: 100)")->type_name("N")->group(group);
  add_number(command, "--flight-time", arguments.flight_time,
             "Time between leaving the wall and touching it, in R/c (with a\nmaterial: s)")
      ->type_name("T")
      ->group(group);
  add_number(command, "--gravity", arguments.gravity,
             "Acceleration g in c^2/R (with a material: m/s^2): a flight lasts 2v/g")
      ->type_name("G")
      ->group(group);
  add_number(command, "--decay-time", arguments.decay_time,
             "In flight vibrational energies fall as exp(-t/TAU); in R/c (with a\n"
             "material: s), 0: at once (default: no decay)")
      ->type_name("TAU")
      ->group(group);
}

}  // namespace

void add_bounce(CLI::App& app) {
  auto* command = app.add_subcommand("bounce", "Impacts of a body that comes back with the vibration it has kept");
  auto arguments = std::make_shared<BounceArguments>();
  arguments->who.first.add_poisson_to(*command);
  command
      ->add_option("--speed", arguments->speed,
                   "Speed of the first impact, 1e-8 to 1 in c of the body (with a\nmaterial: m/s)")
      ->required()
      ->type_name("V")
      ->group("Body");
  arguments->who.add_to(*command, true, "\nA second body that is free does not come back: it is refused");
  arguments->vibration.add_to(*command);
  add_flight(*command, *arguments);
  arguments->tail_option =
      command
          ->add_option("--tail", arguments->tail,
                       "How modes above the cutoff answer (default: radiating); static keeps\nall energy")
          ->check(CLI::IsMember({"radiating", "static"}))
          ->type_name("TAIL")
          ->group("Resolution");
  add_number(*command, "--cutoff", arguments->cutoff, "Modes up to this frequency in c/R are kept (default: 20)")
      ->type_name("OMEGA")
      ->group("Resolution");
  arguments->output.add_to(*command);
  command->footer(
      "Examples:\n"
      "  stoss bounce --body sphere --poisson 0.3 --speed 0.05 --count 200 --flight-time 30\n"
      "  stoss bounce --poisson 0.33 --speed 0.2 --count 5000 --flight-time 31.4 --tail static --cutoff 4\n"
      "  stoss bounce --body sphere --poisson 0.3 --speed 0.05 --flight-time 30 --decay-time 100\n"
      "  stoss bounce --body sphere --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01 --speed 1\n"
      "      --gravity 9.81 --loss-time 1e-9 --count 20");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace stoss::cli
