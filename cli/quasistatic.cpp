// stoss quasistatic: slow impacts and static compression, in closed form where there is one.
#include "stoss/quasistatic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "arguments.hpp"
#include "interrupt.hpp"
#include "numbers.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "stoss/errors.hpp"
#include "tables.hpp"

namespace stoss::cli {
namespace {

using namespace quasistatic;

constexpr double least_compression = 1e-12;  // of static_contact, as the greatest
constexpr double greatest_compression = 0.5;
constexpr double great_compression = 0.1;  // beyond it small strains mean little

struct QuasistaticArguments {
  DiskArguments disk;
  std::string speeds;
  std::string compressions;
  std::string law = "center";
  double cutoff = 60.0;
  OutputArguments output;
  CLI::Option* speed_option = nullptr;
  CLI::Option* compression_option = nullptr;
  CLI::Option* cutoff_option = nullptr;

  [[nodiscard]] CompressionLaw chosen_law() const {
    if (law == "diameter") return CompressionLaw::diameter;
    return law == "printed" ? CompressionLaw::printed : CompressionLaw::center;
  }
};

/// A number of rows that are written one by one, until Ctrl-C.
void write_rows(const QuasistaticArguments& arguments, Report& report, std::size_t count,
                const std::function<Record(std::size_t)>& make) {
  catch_interrupts();
  Progress progress(arguments.output, count);
  try {
    for (std::size_t i = 0; i < count; ++i) {
      heed_interrupts();
      report.add(make(i));
      progress.show(i + 1);
    }
  } catch (const OutputError&) {
    throw;
  } catch (...) {
    report.finish(false);
    throw;
  }
}

Record impact_record(const RayleighEstimate& estimate, const Units& units) {
  const SlowImpact& impact = estimate.impact;
  Record record{{"poisson", "", impact.poisson}, {"speed", "c", impact.speed, units.si ? 0 : 12}};
  if (units.si) record.push_back({"speed_si", "m/s", impact.speed * units.si->speed, 12});
  add_quantities(record, rayleigh_table(), estimate, units);
  return record;
}

void impacts(const QuasistaticArguments& arguments, Provenance provenance) {
  const auto si = arguments.disk.si();
  const double poisson = arguments.disk.plane_poisson();
  const CompressionLaw law = arguments.chosen_law();
  const SpeedRange range{min_slow_speed, limit_speed(law, poisson),
                         "of the centre of mass, 1e-100 c to where the static law ends"};
  const std::vector<double> speeds = parse_speeds(arguments.speeds, si, range);
  const std::vector<bodies::disk::Mode> modes = bodies::disk::modes(poisson, arguments.cutoff);
  provenance.inputs["cutoff"] = arguments.cutoff;
  Report report(Output(arguments.output.path), arguments.output.chosen_format(), provenance);
  std::size_t beyond = 0;
  write_rows(arguments, report, speeds.size(), [&](std::size_t i) {
    const RayleighEstimate estimate = rayleigh(law, poisson, speeds[i], modes, heed_interrupts);
    beyond += estimate.beyond_perturbation ? 1 : 0;
    if (speeds.size() == 1 && arguments.output.chosen_format() == Format::json) {
      report.attach("modes", to_json(driven_mode_table(), estimate.modes));
    }
    return impact_record(estimate, {si});
  });
  report.finish();
  if (beyond > 0) {
    arguments.output.warn(
        fmt::format("{} of {} rows beyond perturbation theory (marked): lost_fraction is no estimate there, but far "
                    "too great (see stoss restitution)",
                    beyond, speeds.size()));
  }
}

/// In R, of numbers that are in R or, with a material, in m. @throws InvalidInput where a quantity has no value
std::vector<double> parse_compressions(const std::string& text, CompressionLaw law, double poisson,
                                       const std::optional<Scales>& si) {
  const double unit = si ? si->length : 1.0;
  const double last_force = std::min(limit_force(law, poisson), max_hertz_force);
  const double greatest = std::min(compression(law, poisson, last_force), greatest_compression);
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

Record compression_record(CompressionLaw law, double poisson, double compression, const Units& units) {
  // The rounding of the inversion must not lead beyond the last force.
  const double last_force = std::min(limit_force(law, poisson), max_hertz_force);
  const double force = std::min(compression_force(law, poisson, compression), last_force);
  const Compressed result{compression, force, compression_energy(law, poisson, force), hertz_half_width(force),
                          static_contact(poisson, compression, {.poll = heed_interrupts})};
  Record record{{"poisson", "", poisson}};
  add_quantities(record, compression_table(), result, units);
  return record;
}

void compressions(const QuasistaticArguments& arguments, const Provenance& provenance) {
  if (arguments.cutoff_option->count() > 0) {
    throw InvalidInput("cutoff: got --cutoff with --compression, allowed only with --speed (here all modes count)");
  }
  const auto si = arguments.disk.si();
  const double poisson = arguments.disk.plane_poisson();
  const CompressionLaw law = arguments.chosen_law();
  const std::vector<double> values = parse_compressions(arguments.compressions, law, poisson, si);
  Report report(Output(arguments.output.path), arguments.output.chosen_format(), provenance);
  write_rows(arguments, report, values.size(),
             [&](std::size_t i) { return compression_record(law, poisson, values[i], {si}); });
  report.finish();
  const auto great = std::count_if(values.begin(), values.end(), [](double v) { return v > great_compression; });
  if (great > 0) {
    arguments.output.warn(fmt::format("{} of {} compressions above {} R: linear elasticity means little there", great,
                                      values.size(), great_compression));
  }
}

void run(const QuasistaticArguments& arguments) {
  const bool speeds = arguments.speed_option->count() > 0;
  if (!speeds && arguments.compression_option->count() == 0) throw CLI::RequiredError("--speed or --compression");
  Provenance provenance{"quasistatic", command_line(), {}};
  arguments.disk.describe(provenance.inputs);
  provenance.inputs["law"] = arguments.law;
  if (speeds) {
    impacts(arguments, provenance);
  } else {
    compressions(arguments, provenance);
  }
}

}  // namespace

void add_quasistatic(CLI::App& app) {
  auto* command = app.add_subcommand("quasistatic", "Slow impacts with an estimate of the loss, or static compression");
  auto arguments = std::make_shared<QuasistaticArguments>();
  arguments->disk.add_to(*command);
  arguments->speed_option = command
                                ->add_option("--speed", arguments->speeds,
                                             "Slow impacts at these speeds, in c (m/s with a material): a number,\n"
                                             "a,b,c, log:a:b:n or lin:a:b:n; 1e-100 c to 0.14 c or more, where\n"
                                             "the law ends")
                                ->type_name("SPEEDS")
                                ->group("Body");
  arguments->compression_option =
      command
          ->add_option("--compression", arguments->compressions,
                       "In place of --speed: static contacts at these compressions, in R\n"
                       "(m with a material): a number, a,b,c, log:a:b:n or lin:a:b:n; 1e-12\n"
                       "to 0.2 or more, where the law or the contact ends (at most 0.5 R).\n"
                       "Gives force, energy and half-width by the law, and the force of the\n"
                       "exact static contact with its error")
          ->excludes(arguments->speed_option)
          ->type_name("DELTAS")
          ->group("Body");
  command
      ->add_option("--law", arguments->law,
                   "Force against compression (default: center)\n"
                   "  center:   approach of the centre of mass to the wall\n"
                   "  diameter: shortening of the diameter between two walls\n"
                   "  printed:  as Gerl and Zippelius print it")
      ->check(CLI::IsMember({"center", "diameter", "printed"}))
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
      "Two equal disks that each move at SPEED towards each other are the same problem.");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace stoss::cli
