// stoss quasistatic: slow impacts and static compression, in closed form where there is one.
#include "quasistatic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "encounter.hpp"
#include "interrupt.hpp"
#include "numbers.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "stoss/errors.hpp"
#include "tables.hpp"
#include "yield.hpp"

namespace stoss::cli {
namespace {

constexpr double great_compression = 0.1;  // beyond it small strains mean little

struct QuasistaticArguments {
  BodyOptions body;
  std::string speeds;
  std::string compressions;
  std::string law = "center";
  double cutoff = 60.0;
  OutputArguments output;
  CLI::Option* speed_option = nullptr;
  CLI::Option* compression_option = nullptr;
  CLI::Option* cutoff_option = nullptr;
};

/// A number of rows that are written one by one, until Ctrl-C.
void write_rows(const QuasistaticArguments& arguments, Report& report, std::size_t count,
                const std::function<Record(std::size_t)>& make) {
  Progress progress(arguments.output, count);
  report.finish_after([&] {
    for (std::size_t i = 0; i < count; ++i) {
      heed_interrupts();
      report.add(make(i));
      progress.show(i + 1);
    }
  });
}

Record slow_impact_key(const QuasistaticBody& body, double speed) {
  const auto& si = body.units.si;
  Record record{{"poisson", "", body.poisson}, {"speed", body.units.own_name(Dimension::speed), speed, si ? 0 : 12}};
  if (si) record.push_back({"speed_si", body.units.si_name(Dimension::speed), speed * si->speed, 12});
  return record;
}

void impacts(const QuasistaticArguments& arguments, const QuasistaticBody& body, Provenance provenance) {
  const std::vector<double> speeds = parse_speeds(arguments.speeds, body.units.si, body.speeds);
  const auto add_impact = body.impacts(arguments.cutoff);
  provenance.inputs["cutoff"] = arguments.cutoff;
  catch_interrupts();
  Report report(Output(arguments.output.path, Output::Use::rows), arguments.output.chosen_format(), provenance);
  std::size_t beyond = 0;
  write_rows(arguments, report, speeds.size(), [&](std::size_t i) {
    Record record = slow_impact_key(body, speeds[i]);
    const SlowRow row = add_impact(speeds[i], record);
    beyond += row.beyond_perturbation ? 1 : 0;
    if (speeds.size() == 1 && arguments.output.chosen_format() == Format::json) {
      report.attach("modes", to_json(driven_mode_table(), row.modes));
    }
    add_yield(record, body.units, body.yield_speed, speeds[i]);
    return record;
  });
  if (beyond > 0) {
    arguments.output.warn(
        fmt::format("{} of {} rows beyond perturbation theory (marked): lost_fraction is no estimate there, but far "
                    "too large (see stoss restitution)",
                    beyond, speeds.size()));
  }
  const double fastest = *std::max_element(speeds.begin(), speeds.end());
  if (body.yield_speed && fastest * body.units.si->speed > *body.yield_speed) {
    arguments.output.warn(yield_warning(*body.yield_speed));
  }
}

/// In R, of numbers that are in R or, with a material, in m. @throws InvalidInput where a quantity has no value
std::vector<double> parse_compressions(const std::string& text, const QuasistaticBody& body) {
  const auto& si = body.units.si;
  const double unit = si ? si->length : 1.0, greatest = body.greatest_compression;
  std::vector<double> values = parse_series("compression", text);
  for (double& value : values) {
    if (!(value >= least_compression * unit && value <= greatest * unit)) {
      throw InvalidInput(
          fmt::format("compression: got {}, allowed {} to {} {} (R + x0; beyond them a law or a contact ends)", value,
                      lower_end(least_compression * unit), upper_end(greatest * unit), si ? "m" : "R"));
    }
    value = std::clamp(value / unit, least_compression, greatest);
  }
  return values;
}

void compressions(const QuasistaticArguments& arguments, const QuasistaticBody& body, const Provenance& provenance) {
  if (arguments.cutoff_option->count() > 0) {
    throw InvalidInput("cutoff: got --cutoff with --compression, allowed only with --speed (here all modes count)");
  }
  if (body.yield_speed) {
    throw InvalidInput(
        "yield: got --yield with --compression, allowed only with --speed (give the speed, not the compression)");
  }
  const std::vector<double> values = parse_compressions(arguments.compressions, body);
  catch_interrupts();
  Report report(Output(arguments.output.path, Output::Use::rows), arguments.output.chosen_format(), provenance);
  write_rows(arguments, report, values.size(), [&](std::size_t i) {
    Record record{{"poisson", "", body.poisson}};
    body.compress(values[i], record);
    return record;
  });
  const auto great = std::count_if(values.begin(), values.end(), [](double v) { return v > great_compression; });
  if (great > 0) {
    arguments.output.warn(fmt::format("{} of {} compressions above {} R: linear elasticity means little there", great,
                                      values.size(), great_compression));
  }
}

QuasistaticBody chosen_body(const Encounter& encounter, const std::string& law) {
  return encounter.first.kind == "sphere" ? point_quasistatic(encounter, law) : line_quasistatic(encounter, law);
}

void run(const QuasistaticArguments& arguments) {
  const bool speeds = arguments.speed_option->count() > 0;
  if (!speeds && arguments.compression_option->count() == 0) throw CLI::RequiredError("--speed or --compression");
  Provenance provenance{"quasistatic", command_line(), {}};
  const Encounter encounter{.first = arguments.body.body()};
  validate(encounter);
  describe_first(encounter, provenance.inputs);
  const QuasistaticBody body = chosen_body(encounter, arguments.law);
  provenance.inputs["law"] = arguments.law;
  if (speeds) {
    impacts(arguments, body, provenance);
  } else {
    compressions(arguments, body, provenance);
  }
}

}  // namespace

void add_quasistatic(CLI::App& app) {
  auto* command = app.add_subcommand("quasistatic", "Slow impacts with an estimate of the loss, or static compression");
  auto arguments = std::make_shared<QuasistaticArguments>();
  arguments->body.add_kind_to(*command, {"disk", "sphere"});
  arguments->body.add_poisson_to(*command);
  arguments->body.add_material_to(*command, true);
  arguments->speed_option = command
                                ->add_option("--speed", arguments->speeds,
                                             "Slow impacts at these speeds, in c (m/s with a material): a number,\n"
                                             "a,b,c, log:a:b:n or lin:a:b:n; 1e-100 c (of a sphere 1e-12 c) to\n"
                                             "0.14 c or more, where the law ends")
                                ->type_name("SPEEDS")
                                ->group("Body");
  arguments->compression_option =
      command
          ->add_option("--compression", arguments->compressions,
                       "In place of --speed: static contacts at these compressions, in R\n"
                       "(m with a material): a number, a,b,c, log:a:b:n or lin:a:b:n; 1e-12\n"
                       "to 0.2 or more, where the law or the contact ends (at most 0.5 R).\n"
                       "Gives force, energy and half-width or radius of the contact by the\n"
                       "law, and the force of the exact static contact with its error")
          ->excludes(arguments->speed_option)
          ->type_name("DELTAS")
          ->group("Body");
  command
      ->add_option("--law", arguments->law,
                   "Force against compression (default: center)\n"
                   "  center:   approach of the centre of mass to the wall\n"
                   "  diameter: of a disk, shortening of the diameter between two walls\n"
                   "  printed:  of a disk, as Gerl and Zippelius print it\n"
                   "  hertz:    of a sphere, two half-spaces")
      ->check(CLI::IsMember({"center", "diameter", "printed", "hertz"}))
      ->type_name("LAW")
      ->group("Body");
  arguments->cutoff_option = add_number(*command, "--cutoff", arguments->cutoff,
                                        "With --speed: highest frequency in Rayleigh's estimate, in c/R,\n"
                                        "up to 1000 (default: 60)")
                                 ->type_name("OMEGA")
                                 ->group("Resolution");
  arguments->output.add_to(*command);
  command->footer(
      "Examples:\n"
      "  stoss quasistatic --poisson 0.33 --speed log:1e-6:0.1:50\n"
      "  stoss quasistatic --poisson 0.33 --speed 1e-12 --format json\n"
      "  stoss quasistatic --poisson 0.33 --compression lin:0.001:0.03:20\n"
      "  stoss quasistatic --body sphere --poisson 0.3 --speed log:1e-9:0.01:50\n"
      "Two equal bodies that each move at SPEED towards each other are the same problem.");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace stoss::cli
