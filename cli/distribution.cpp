// stoss distribution: the coefficient of restitution of many bodies that vibrate at random.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "arguments.hpp"
#include "encounter.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "numbers.hpp"
#include "options.hpp"
#include "row_output.hpp"
#include "samples.hpp"
#include "stoss/errors.hpp"
#include "tables.hpp"
#include "vibration_arguments.hpp"
#include "yield.hpp"

namespace stoss::cli {
namespace {

struct DistributionArguments {
  EncounterOptions who;
  SpectrumArguments spectrum;
  std::string speed;
  int samples = 1000;
  int seed = 0;
  double error = 1e-3;
  int threads = 0;
  RowOutput output;
};

DistributionOptions options(const DistributionArguments& arguments) {
  if (arguments.seed < 0) {
    throw InvalidInput(
        fmt::format("seed: got {}, allowed 0 to 2147483647 (another one, another ensemble)", arguments.seed));
  }
  return {.samples = arguments.samples,
          .seed = static_cast<std::uint64_t>(arguments.seed),
          .error = arguments.error,
          .threads = arguments.threads,
          .poll = heed_interrupts};
}

Ensemble make_ensemble(const DistributionArguments& arguments, const Encounter& encounter) {
  if (is_soft(encounter)) {
    throw InvalidInput("against: got exponential, allowed wall, same or a body");
  }
  const Units units = units_of(encounter);
  const std::vector<double> speeds = parse_speeds(arguments.speed, units.si);
  if (speeds.size() != 1) throw InvalidInput(fmt::format("speed: got {} speeds, allowed one", speeds.size()));
  RefinableContact contact = refinable(encounter);
  Spectrum spectrum = arguments.spectrum.spectrum(contact, heed_interrupts);
  Ensemble ensemble{std::move(contact), speeds.front(), std::move(spectrum), options(arguments), units};
  validate(ensemble.contact, ensemble.speed, ensemble.spectrum, ensemble.options);
  return ensemble;
}

Provenance describe(const DistributionArguments& arguments, const Encounter& encounter, const Ensemble& ensemble) {
  Provenance provenance{"distribution", command_line(), {}};
  auto& inputs = provenance.inputs;
  cli::describe(encounter, inputs);
  const auto& si = ensemble.units.si;
  inputs[si ? "speed[m/s]" : "speed"] = parse_series("speed", arguments.speed).front();
  arguments.spectrum.describe(inputs);
  inputs["modes"] = ensemble.spectrum.size();
  inputs["samples"] = arguments.samples;
  inputs["seed"] = arguments.seed;
  inputs["error"] = arguments.error;
  return provenance;
}

/// Adds the summary to what is written, or says it.
void summarize(const std::vector<Sample>& samples, const OutputArguments& output, Report& report) {
  const auto has_value = [](const Sample& sample) { return std::isfinite(sample.restitution.value); };
  if (std::none_of(samples.begin(), samples.end(), has_value)) return;
  const DistributionSummary all = summary(samples);
  const std::string lines = summary_lines(all);
  if (output.chosen_format() == Format::json) {
    auto object = to_json(distribution_table(), all);
    for (auto& value : object) {
      if (value.is_number_float() && !std::isfinite(value.get<double>())) value = unknown;
    }
    report.attach("summary", std::move(object));
  }
  if (output.chosen_format() == Format::table) report.close_table("\n" + lines);
  if (output.chosen_format() == Format::csv && !output.quiet) show(lines);
}

int run(DistributionArguments arguments) {
  arguments.output.redirect();
  const OutputArguments& output = arguments.output.output;
  const Encounter encounter = arguments.who.encounter();
  catch_interrupts();
  const Ensemble ensemble = make_ensemble(arguments, encounter);
  std::vector<Sample> samples;
  Sweep sweep(sample_rows(ensemble, samples), output);
  arguments.output.write(describe(arguments, encounter, ensemble), sweep, [&](Report& report) {
    compute_samples(ensemble, sweep, report);
    summarize(samples, output, report);
  });
  const auto yield = yield_speed(encounter);
  if (yield && ensemble.speed * ensemble.units.si->speed > *yield) output.warn(yield_warning(*yield));
  return sweep.conclude();
}

void add_ensemble(CLI::App& command, DistributionArguments& arguments) {
  arguments.spectrum.add_to(command);
  add_integer(command, "--samples", arguments.samples, "How many impacts, 1 to 1e6 (default: 1000)")
      ->type_name("N")
      ->group("Ensemble");
  add_integer(command, "--seed", arguments.seed, "Another seed, another ensemble: 0 to 2147483647 (default: 0)")
      ->type_name("SEED")
      ->group("Ensemble");
  add_number(command, "--error", arguments.error, "Error of 1-eps^2 of each to reach, 1e-9 to 0.5 (default: 0.001)")
      ->type_name("ERROR")
      ->group("Resolution");
  add_threads(command, arguments.threads);
}

}  // namespace

void add_distribution(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("distribution", "Coefficients of restitution of bodies that vibrate at random");
  auto arguments = std::make_shared<DistributionArguments>();
  arguments->who.first.add_poisson_to(*command);
  command
      ->add_option("--speed", arguments->speed, "Speed of approach, 1e-8 to 1 in c of the body (with a material: m/s)")
      ->required()
      ->type_name("V")
      ->group("Body");
  arguments->who.add_to(*command);
  add_ensemble(*command, *arguments);
  arguments->output.add_to(*command);
  command->footer(
      "Examples:\n"
      "  stoss distribution --body sphere --poisson 0.3 --speed 0.01 --temperature 0.01 --seed 7\n"
      "  stoss distribution --body sphere --poisson 0.3 --speed 0.01 --temperature 0.01 --highest 20\n"
      "      --samples 1e4 --resume samples.csv\n"
      "  stoss distribution --body rod --speed 0.1 --against rod,length=2.5 --temperature 0.02 --error 0.02\n"
      "  stoss distribution --poisson 0.33 --speed 0.1 --spectrum 2,0,energy=0.1 --format json");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace stoss::cli
