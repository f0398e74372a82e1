// stoss quasistatic: slow impacts and static compression, in closed form where there is one.
#include "commands/quasistatic.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app.hpp"
#include "input/encounter.hpp"
#include "output/output_options.hpp"
#include "output/progress.hpp"
#include "process/process.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic/quantities.hpp"

namespace stoss::cli {
namespace {

struct QuasistaticArguments {
  BodyOptions body;
  std::string speeds;
  std::string compressions;
  std::string law = "center";
  double cutoff = 60.0;
  OutputOptions output;
  CLI::App* command = nullptr;
};

/// A number of rows that are written one by one, until Ctrl-C.
void write_rows(const OutputOptions& output, Writer& writer, std::size_t count,
                const std::function<Row(std::size_t)>& make) {
  Progress progress(output, count);
  writer.finish_after([&] {
    for (std::size_t i = 0; i < count; ++i) {
      heed_interrupts();
      writer.add(make(i));
      progress.show(i + 1);
    }
  });
}

void impacts(const QuasistaticArguments& arguments, const QuasistaticBody& body, const Yielding& yielding,
             Provenance provenance) {
  const Units& units = yielding.units;
  const OutputOptions& output = arguments.output;
  const std::vector<double> speeds = parse_series_in("speed", arguments.speeds, Dimension::speed, units, body.speeds);
  const auto impact = body.impacts(arguments.cutoff);
  provenance.inputs["cutoff"] = arguments.cutoff;
  catch_interrupts();
  Columns columns{{"poisson"}};
  for (const Columns& more : {speed_columns(units), body.impact_columns, yielding.columns()}) append(columns, more);
  Writer writer = output.writer(provenance, columns);
  std::size_t beyond = 0;
  write_rows(output, writer, speeds.size(), [&](std::size_t i) {
    const SlowImpactRow its = impact(speeds[i]);
    beyond += its.beyond_perturbation ? 1 : 0;
    if (speeds.size() == 1 && output.chosen_format() == Format::json) {
      writer.attach("modes", to_json(quasistatic::driven_mode_quantities(), its.modes));
    }
    Row row{body.poisson};
    for (const Row& more : {speed_row(units, speeds[i]), its.row, yielding.row(speeds[i])}) append(row, more);
    return row;
  });
  if (beyond > 0) {
    output.warn(
        fmt::format("{} of {} rows beyond perturbation theory (marked): lost_fraction is no estimate there, but far "
                    "too large (see stoss restitution)",
                    beyond, speeds.size()));
  }
  const double fastest = *std::max_element(speeds.begin(), speeds.end());
  if (yielding.is_below(fastest)) output.warn(yield_warning(*yielding.speed));
}

void compressions(const QuasistaticArguments& arguments, const QuasistaticBody& body, const Yielding& yielding,
                  const Provenance& provenance) {
  if (given(*arguments.command, "--cutoff")) {
    throw InvalidInput("cutoff: got --cutoff with --compression, allowed only with --speed (here all modes count)");
  }
  if (yielding.speed) {
    throw InvalidInput(
        "yield: got --yield with --compression, allowed only with --speed (give the speed, not the compression)");
  }
  const OutputOptions& output = arguments.output;
  const Allowed allowed{least_compression, body.greatest_compression, "R + x0; beyond them a law or a contact ends"};
  const std::vector<double> values =
      parse_series_in("compression", arguments.compressions, Dimension::length, yielding.units, allowed);
  catch_interrupts();
  Columns columns{{"poisson"}};
  append(columns, body.contact_columns);
  Writer writer = output.writer(provenance, columns);
  write_rows(output, writer, values.size(), [&](std::size_t i) {
    Row row{body.poisson};
    append(row, body.compress(values[i]));
    return row;
  });
  constexpr double great_compression = 0.1;  // beyond it small strains mean little
  const auto great = std::count_if(values.begin(), values.end(), [](double v) { return v > great_compression; });
  if (great > 0) {
    output.warn(fmt::format("{} of {} compressions above {} R: linear elasticity means little there", great,
                            values.size(), great_compression));
  }
}

void run(const QuasistaticArguments& arguments) {
  const bool speeds = given(*arguments.command, "--speed");
  if (!speeds && !given(*arguments.command, "--compression")) throw CLI::RequiredError("--speed or --compression");
  Provenance provenance{"quasistatic", command_line(), {}};
  const Encounter encounter{.first = arguments.body.body()};
  validate(encounter);
  describe_first(encounter, provenance.inputs);
  const QuasistaticBody body = quasistatic_body(encounter, arguments.law);
  provenance.inputs["law"] = arguments.law;
  if (speeds) {
    impacts(arguments, body, yielding(encounter), provenance);
  } else {
    compressions(arguments, body, yielding(encounter), provenance);
  }
}

}  // namespace

void add_quasistatic(CLI::App& app) {
  auto& arguments = add_subcommand<QuasistaticArguments>(
      app, "quasistatic", "Slow impacts with an estimate of the loss, or static compression", run,
      "Examples:\n"
      "  stoss quasistatic --poisson 0.33 --speed log:1e-6:0.1:50\n"
      "  stoss quasistatic --poisson 0.33 --speed 1e-12 --format json\n"
      "  stoss quasistatic --poisson 0.33 --compression lin:0.001:0.03:20\n"
      "  stoss quasistatic --body sphere --poisson 0.3 --speed log:1e-9:0.01:50\n"
      "Two equal bodies that each move at SPEED towards each other are the same problem.");
  CLI::App& command = *arguments.command;
  arguments.body.add_kind_to(command, {"disk", "sphere"});
  arguments.body.add_poisson_to(command);
  arguments.body.add_material_to(command, true);
  auto* speed = add(command, "--speed", arguments.speeds,
                    "Slow impacts at these speeds, in c (m/s with a material): a number,\n"
                    "a,b,c, log:a:b:n or lin:a:b:n; 1e-100 c (of a sphere 1e-12 c) to\n"
                    "0.14 c or more, where the law ends",
                    "SPEEDS", "Body");
  add(command, "--compression", arguments.compressions,
      "In place of --speed: static contacts at these compressions, in R\n"
      "(m with a material): a number, a,b,c, log:a:b:n or lin:a:b:n; 1e-12\n"
      "to 0.2 or more, where the law or the contact ends (at most 0.5 R).\n"
      "Gives force, energy and half-width or radius of the contact by the\n"
      "law, and the force of the exact static contact with its error",
      "DELTAS", "Body")
      ->excludes(speed);
  add_choice(command, "--law", arguments.law, {"center", "diameter", "printed", "hertz"},
             "Force against compression (default: center)\n"
             "  center:   approach of the centre of mass to the wall\n"
             "  diameter: of a disk, shortening of the diameter between two walls\n"
             "  printed:  of a disk, as Gerl and Zippelius print it\n"
             "  hertz:    of a sphere, two half-spaces",
             "LAW", "Body");
  add(command, "--cutoff", arguments.cutoff,
      "With --speed: highest frequency in Rayleigh's estimate, in c/R,\nup to 1000 (default: 60)", "OMEGA",
      "Resolution");
  arguments.output.add_to(command);
}

}  // namespace stoss::cli
