// stoss pulse: the force of one impact in time, with its error, and its spectrum.
#include <fmt/format.h>

#include <optional>
#include <utility>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/output_options.hpp"
#include "process/process.hpp"
#include "stoss/encounter/seismogram.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss::cli {
namespace {

struct PulseArguments {
  EncounterOptions who;
  ApproachOptions approach;
  double tolerance = 1e-2, threshold = 1e-2;
  int points = 400;
  std::optional<double> distance, depth, until;  // of a receiver
  OutputOptions output;
  CLI::App* command = nullptr;
};

/// What the command shows.
struct Shot {
  Pulse pulse;
  std::optional<Seismogram> seismogram;
};

/// Series in the units of all results, or in SI with a material, and the names of their units.
class SeriesOf {
 public:
  explicit SeriesOf(const Units& units) : units_(units) {}

  void add(const std::string& name, Dimension dimension, const std::vector<double>& values) {
    const double unit = units_.si ? unit_in_si(dimension, *units_.si) : 1.0;
    auto& list = details_[name] = nlohmann::ordered_json::array();
    for (const double each : values) list.push_back(each * unit);
    names_[name] = units_.si ? std::string(unit_name(dimension, units_.in_si)) : units_.own_name(dimension);
  }

  /// The motion of the receiver: its time as receiver_time, as it is not that of the pulse, and no force.
  void add(const std::vector<RecordedInstant>& instants) {
    for (const auto& each : recorded_instant_quantities()) {
      if (each.name == "force") continue;
      std::vector<double> values, errors;
      for (const RecordedInstant& at : instants) {
        values.push_back(std::get<double>(each.value(at)));
        if (each.error) errors.push_back(each.error(at));
      }
      add(each.error ? each.name : "receiver_" + each.name, each.dimension, values);
      if (each.error) add(each.name + "_error", each.dimension, errors);
    }
  }

  [[nodiscard]] nlohmann::ordered_json taken() {
    details_["series_units"] = names_;
    return details_;
  }

 private:
  const Units& units_;
  nlohmann::ordered_json details_, names_;
};

nlohmann::ordered_json series_of(const Shot& shot, const Units& units) {
  const Pulse& pulse = shot.pulse;
  SeriesOf all(units);
  all.add("time", Dimension::time, pulse.time);
  all.add("force", Dimension::force, pulse.force);
  all.add("force_error", Dimension::force, pulse.force_error);
  all.add("frequency", Dimension::frequency, pulse.frequency);
  all.add("amplitude", Dimension::none, pulse.amplitude);
  all.add("amplitude_error", Dimension::none, pulse.amplitude_error);
  if (shot.seismogram) all.add(shot.seismogram->instants);
  return all.taken();
}

/// A row for each instant: of the receiver, where there is one.
void write_instants(const PulseArguments& arguments, const Provenance& its, const Units& units, const Shot& shot) {
  if (shot.seismogram) {
    const Fields<RecordedInstant> fields(recorded_instant_quantities(), units);
    Writer writer = arguments.output.writer(its, fields.columns());
    for (const RecordedInstant& each : shot.seismogram->instants) writer.add(fields.row(each));
    return writer.finish();
  }
  const Fields<PulseInstant> fields(pulse_instant_quantities(), units);
  Writer writer = arguments.output.writer(its, fields.columns());
  const Pulse& pulse = shot.pulse;
  for (std::size_t i = 0; i < pulse.time.size(); ++i) {
    writer.add(fields.row({pulse.time[i], {pulse.force[i], pulse.force_error[i]}}));
  }
  writer.finish();
}

void write(const PulseArguments& arguments, const Encounter& encounter, double speed, const Shot& shot) {
  const Units units = units_of(encounter);
  const Provenance its = provenance(*arguments.command, encounter);
  const OutputOptions& output = arguments.output;
  if (output.chosen_format() == Format::csv) return write_instants(arguments, its, units, shot);
  const Fields<Pulse> fields(pulse_quantities(), units,
                             {{"peak_force", {.width = 24, .si_width = 14, .with_error = true}},
                              {"contact_time", {.width = 18, .si_width = 18, .with_error = true}},
                              {"rise", {.width = 14, .si_width = 14, .with_error = true}}});
  const Fields<Seismogram> received(seismogram_quantities(), units,
                                    {{"max_normal", {.width = 22, .si_width = 14, .with_error = true}},
                                     {"max_radial", {.width = 22, .si_width = 14, .with_error = true}}});
  Columns columns = speed_columns(units);
  append(columns, fields.columns());
  Row row = speed_row(units, speed);
  append(row, fields.row(shot.pulse));
  if (shot.seismogram) append(columns, received.columns()), append(row, received.row(*shot.seismogram));
  Writer writer = output.writer(its, columns);
  writer.add(row, output.chosen_format() == Format::json ? series_of(shot, units) : nlohmann::ordered_json::object());
  if (output.chosen_format() == Format::table) {
    writer.close_table(shot.seismogram ? "\nThe receiver in time: --format csv; with the force: --format json\n"
                                       : "\nThe force in time: --format csv; with its spectrum: --format json\n");
  }
  writer.finish();
}

/// Where the receiver is and until when it records, in units of the first body.
struct Place {
  Receiver receiver;
  double until = 0.0;
};

/// That of the options, if one is given.
std::optional<Place> place_of(const PulseArguments& arguments, const Units& units) {
  if (!arguments.distance && !arguments.depth) {
    if (arguments.until) {
      throw InvalidInput::conflict("until", "a time without a receiver", "add --distance or --depth");
    }
    return {};
  }
  const auto own = [&](const char* name, const std::optional<double>& value) {
    return value ? own_value(input(Question::pulse, name), *value, units) : 0.0;
  };
  return Place{{own("distance", arguments.distance), own("depth", arguments.depth)}, own("until", arguments.until)};
}

void run(const PulseArguments& arguments) {
  const Encounter encounter = arguments.who.encounter();
  const double speed = arguments.approach.one(units_of(encounter));
  const std::optional<Place> place = place_of(arguments, units_of(encounter));
  catch_interrupts();
  const Poll poll = waiting(arguments.output, "computes the pulse");
  Shot shot{stoss::pulse(refinable(encounter), speed,
                         {.tolerance = arguments.tolerance,
                          .threshold = arguments.threshold,
                          .points = arguments.points,
                          .poll = poll,
                          .vibration = encounter.vibration}),
            {}};
  const Pulse& pulse = shot.pulse;
  if (place) {
    shot.seismogram = seismogram(encounter, pulse, place->receiver,
                                 {.until = place->until, .points = arguments.points, .poll = poll});
  }
  write(arguments, encounter, speed, shot);
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
      "  stoss pulse --body sphere --poisson 0.3 --speed 0.001 --against plate,thickness=4 --depth 4 --format csv\n"
      "  stoss pulse --body rod --speed 0.01 --format json");
  CLI::App& command = *arguments.command;
  arguments.who.first.add_poisson_to(command);
  arguments.approach.add_to(command, Question::pulse, "Motion");
  arguments.who.add_to(command);
  add_modes_to(command, arguments.who.modes);
  add_input(command, Question::pulse, "threshold", arguments.threshold, "Pulse");
  add_input(command, Question::pulse, "points", arguments.points, "Pulse");
  for (auto [name, value] :
       {std::pair{"distance", &arguments.distance}, {"depth", &arguments.depth}, {"until", &arguments.until}}) {
    add_input(command, Question::pulse, name, *value, "Receiver");
  }
  add_input(command, Question::pulse, "tolerance", arguments.tolerance, "Resolution");
  arguments.output.add_to(command);
}

}  // namespace stoss::cli
