// stoss bounce: one body that comes back to what it meets, again and again.
#include "stoss/vibration/bounce.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/output_options.hpp"
#include "process/process.hpp"
#include "stoss/errors.hpp"
#include "stoss/vibration/quantities.hpp"

namespace stoss::cli {
namespace {

struct BounceArguments {
  EncounterOptions who;
  ApproachOptions approach;
  int count = 100;
  std::optional<double> flight_time, gravity, decay_time;
  KeptOptions kept;
  OutputOptions output;
  CLI::App* command = nullptr;
};

BounceOptions make_options(const BounceArguments& arguments, const Encounter& encounter, const Units& units) {
  const auto own = [&](const char* name, const std::optional<double>& value) {
    return value ? std::optional(own_value(input(Question::bounce, name), *value, units)) : std::nullopt;
  };
  return {.count = arguments.count,
          .flight_time = own("flight_time", arguments.flight_time),
          .gravity = own("gravity", arguments.gravity),
          .decay_time = own("decay_time", arguments.decay_time),
          .resolution = {.tail = arguments.kept.tail()},
          .vibration = encounter.vibration,
          .poll = waiting(arguments.output, "bounces")};
}

Fields<Bounce> bounce_fields(const Units& units) {
  const Shown shown{.width = 13, .si_width = 13};
  return Fields<Bounce>(bounce_quantities(), units,
                        {{"number", {.width = 8}},
                         {"speed", shown},
                         {"restitution", shown},
                         {"translation", shown},
                         {"vibration", shown},
                         {"dissipated", shown},
                         {"unresolved", shown},
                         {"flight_time", {.width = 13, .si_width = 16}}});
}

void run(const BounceArguments& asked_for) {
  BounceArguments arguments = asked_for;
  const Encounter encounter = arguments.who.encounter();
  const Units units = units_of(encounter);
  const double first = arguments.approach.one(units, "that of the first impact");
  const double slowest = slowest_bounce(first);
  catch_interrupts();
  const BounceOptions options = make_options(arguments, encounter, units);
  KeptOptions& kept = arguments.kept;
  kept.choose(*arguments.command, encounter, slowest, 20.0, options.poll);
  const Contact contact = contact_of(encounter, kept.cutoff, slowest, options.poll);
  validate(contact, first, options);

  const Fields<Bounce> its = bounce_fields(units);
  const Yielding yielding = cli::yielding(encounter);
  Columns columns = its.columns();
  append(columns, yielding.columns());
  double fastest = 0.0;
  double strain = 0.0;  // greatest that is beyond what is small
  long short_flights = 0;
  const OutputOptions& output = arguments.output;
  Writer writer = output.writer(kept.provenance(*arguments.command, encounter), columns);
  writer.finish_after([&] {
    bounce(contact, first, options, [&](const Bounce& bounce, const Impact&) {
      Row row = its.row(bounce);
      append(row, yielding.row(bounce.speed));
      writer.add(row);
      fastest = std::max(fastest, bounce.speed);
      if (bounce.beyond_small_strain) strain = std::max(strain, bounce.strain);
      short_flights += bounce.short_flight ? 1 : 0;
    });
  });
  if (strain > 0.0) output.warn_of_strain(strain);
  if (short_flights > 0) {
    output.warn(
        fmt::format("{} flights too short for the vibration to keep clear of the wall (short_flight)", short_flights));
  }
  if (fastest > 0.0) warn_of_materials(output, encounter, fastest);
}

void add_flight(CLI::App& command, BounceArguments& arguments) {
  const std::string group = "Flight (one of flight-time, gravity)";
  add_input(command, Question::bounce, "count", arguments.count, group);
  add_input(command, Question::bounce, "flight_time", arguments.flight_time, group);
  add_input(command, Question::bounce, "gravity", arguments.gravity, group);
  add_input(command, Question::bounce, "decay_time", arguments.decay_time, group);
}

}  // namespace

void add_bounce(CLI::App& app) {
  auto& arguments = add_subcommand<BounceArguments>(
      app, "bounce", "Impacts of a body that comes back with the vibration it has kept", run,
      "Examples:\n"
      "  stoss bounce --body sphere --poisson 0.3 --speed 0.05 --count 200 --flight-time 30\n"
      "  stoss bounce --body disk --poisson 0.33 --speed 0.2 --count 5000 --flight-time 31.4 --tail static --cutoff 4\n"
      "  stoss bounce --body sphere --poisson 0.3 --speed 0.05 --flight-time 30 --decay-time 100\n"
      "  stoss bounce --body sphere --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01 --speed 1\n"
      "      --gravity 9.81 --loss-time 1e-9 --count 20");
  CLI::App& command = *arguments.command;
  arguments.who.first.add_poisson_to(command);
  arguments.approach.add_to(command, Question::bounce, "Motion");
  arguments.who.add_to(command, "\nA second body that is free does not come back: it is refused");
  add_modes_to(command, arguments.who.modes);
  add_flight(command, arguments);
  arguments.kept.add_to(command, Question::bounce);
  arguments.output.add_to(command);
}

}  // namespace stoss::cli
