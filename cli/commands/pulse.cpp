// stoss pulse: the force of one impact in time, with its error, and its spectrum.
#include <fmt/format.h>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/output_options.hpp"
#include "process/process.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss::cli {
namespace {

struct PulseArguments {
  EncounterOptions who;
  ApproachOptions approach;
  double tolerance = 1e-2, threshold = 1e-2;
  int points = 400;
  OutputOptions output;
  CLI::App* command = nullptr;
};

/// The series behind, with a material in SI.
nlohmann::ordered_json series_of(const Pulse& pulse, const Units& units) {
  nlohmann::ordered_json details, names;
  const auto add = [&](const char* name, Dimension dimension, const std::vector<double>& values) {
    const double unit = units.si ? unit_in_si(dimension, *units.si) : 1.0;
    auto& list = details[name] = nlohmann::ordered_json::array();
    for (const double each : values) list.push_back(each * unit);
    names[name] = units.si ? std::string(unit_name(dimension, units.in_si)) : units.own_name(dimension);
  };
  add("time", Dimension::time, pulse.time);
  add("force", Dimension::force, pulse.force);
  add("force_error", Dimension::force, pulse.force_error);
  add("frequency", Dimension::frequency, pulse.frequency);
  add("amplitude", Dimension::none, pulse.amplitude);
  add("amplitude_error", Dimension::none, pulse.amplitude_error);
  details["series_units"] = names;
  return details;
}

void write(const PulseArguments& arguments, const Encounter& encounter, double speed, const Pulse& pulse) {
  const Units units = units_of(encounter);
  const Provenance its = provenance(*arguments.command, encounter);
  const OutputOptions& output = arguments.output;
  if (output.chosen_format() == Format::csv) {
    const Fields<PulseInstant> fields(pulse_instant_quantities(), units);
    Writer writer = output.writer(its, fields.columns());
    for (std::size_t i = 0; i < pulse.time.size(); ++i) {
      writer.add(fields.row({pulse.time[i], {pulse.force[i], pulse.force_error[i]}}));
    }
    return writer.finish();
  }
  const Fields<Pulse> fields(pulse_quantities(), units,
                             {{"peak_force", {.width = 24, .si_width = 14, .with_error = true}},
                              {"contact_time", {.width = 18, .si_width = 18, .with_error = true}},
                              {"rise", {.width = 14, .si_width = 14, .with_error = true}}});
  Columns columns = speed_columns(units);
  append(columns, fields.columns());
  Row row = speed_row(units, speed);
  append(row, fields.row(pulse));
  Writer writer = output.writer(its, columns);
  writer.add(row, output.chosen_format() == Format::json ? series_of(pulse, units) : nlohmann::ordered_json::object());
  if (output.chosen_format() == Format::table) {
    writer.close_table("\nThe force in time: --format csv; with its spectrum: --format json\n");
  }
  writer.finish();
}

void run(const PulseArguments& arguments) {
  const Encounter encounter = arguments.who.encounter();
  const double speed = arguments.approach.one(units_of(encounter));
  catch_interrupts();
  const Pulse pulse = stoss::pulse(refinable(encounter), speed,
                                   {.tolerance = arguments.tolerance,
                                    .threshold = arguments.threshold,
                                    .points = arguments.points,
                                    .poll = waiting(arguments.output, "computes the pulse"),
                                    .vibration = encounter.vibration});
  write(arguments, encounter, speed, pulse);
  if (pulse.finest.beyond_small_strain) arguments.output.warn_of_strain(pulse.finest.strain);
  warn_of_materials(arguments.output, encounter, speed);
  if (pulse.converged) return;
  arguments.output.warn("the force is not as accurate as asked for: " + pulse.reason);
  throw NotAsAsked{};
}

}  // namespace

void add_pulse(CLI::App& app) {
  auto& arguments = add_subcommand<PulseArguments>(
      app, "pulse", "Force of one impact in time, with its error, and its spectrum", run,
      "Examples:\n"
      "  stoss pulse --body sphere --poisson 0.3 --speed 0.01\n"
      "  stoss pulse --body sphere --material 'bearing steel' --radius 0.003 --height 0.2\n"
      "      --against half-space,material=glass --format csv -o pulse.csv\n"
      "  stoss pulse --body rod --speed 0.01 --format json");
  CLI::App& command = *arguments.command;
  arguments.who.first.add_poisson_to(command);
  arguments.approach.add_to(command, Question::pulse, "Motion");
  arguments.who.add_to(command);
  add_modes_to(command, arguments.who.modes);
  add_input(command, Question::pulse, "threshold", arguments.threshold, "Pulse");
  add_input(command, Question::pulse, "points", arguments.points, "Pulse");
  add_input(command, Question::pulse, "tolerance", arguments.tolerance, "Resolution");
  arguments.output.add_to(command);
}

}  // namespace stoss::cli
