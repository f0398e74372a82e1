// stoss distribution: the coefficient of restitution of many bodies that vibrate at random.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "app.hpp"
#include "commands/samples.hpp"
#include "input/encounter.hpp"
#include "input/options.hpp"
#include "input/speeds.hpp"
#include "input/vibration.hpp"
#include "output/yield.hpp"
#include "process/interrupt.hpp"
#include "process/text.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"
#include "stoss/vibration/quantities.hpp"

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
  RowOptions rows;
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
  refuse_soft(encounter);
  const Units units = units_of(encounter);
  const double speed = parse_speed(arguments.speed, units);
  RefinableContact contact = refinable(encounter);
  Spectrum spectrum = arguments.spectrum.spectrum(contact, heed_interrupts);
  Ensemble ensemble{std::move(contact), speed, std::move(spectrum), options(arguments), units};
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

/// The summary as JSON has it.
nlohmann::ordered_json to_json(const DistributionSummary& all) {
  auto object = cli::to_json(distribution_quantities(), std::vector{all}).front();
  for (auto& value : object) {
    if (value.is_number_float() && !std::isfinite(value.get<double>())) value = unknown;
  }
  return object;
}

/// Adds the summary to what is written, or says it.
void summarize(const std::vector<Sample>& samples, const OutputOptions& output, Writer& writer) {
  const auto has_value = [](const Sample& sample) { return std::isfinite(sample.restitution.value); };
  if (std::none_of(samples.begin(), samples.end(), has_value)) return;
  const DistributionSummary all = summary(samples);
  const std::string lines = summary_lines(all);
  const Format format = output.chosen_format();
  if (format == Format::json) writer.attach("summary", to_json(all));
  if (format == Format::table) writer.close_table("\n" + lines);
  if (format == Format::csv && !output.quiet) show(lines);
}

int run(DistributionArguments arguments) {
  arguments.rows.redirect();
  const OutputOptions& output = arguments.rows.output;
  const Encounter encounter = arguments.who.encounter();
  catch_interrupts();
  const Ensemble ensemble = make_ensemble(arguments, encounter);
  std::vector<Sample> samples;
  RowRun run(sample_plan(ensemble, samples), arguments.rows);
  run.write(describe(arguments, encounter, ensemble), [&] {
    compute_samples(ensemble, run);
    summarize(samples, output, run.writer());
  });
  if (const Yielding its = yielding(encounter); its.is_below(ensemble.speed)) output.warn(yield_warning(*its.speed));
  return run.conclude();
}

void add_ensemble(CLI::App& command, DistributionArguments& arguments) {
  arguments.spectrum.add_to(command);
  add(command, "--samples", arguments.samples, "How many impacts, 1 to 1e6 (default: 1000)", "N", "Ensemble");
  add(command, "--seed", arguments.seed, "Another seed, another ensemble: 0 to 2147483647 (default: 0)", "SEED",
      "Ensemble");
  add(command, "--error", arguments.error, "Error of 1-eps^2 of each to reach, 1e-9 to 0.5 (default: 0.001)", "ERROR",
      "Resolution");
  add_threads(command, arguments.threads);
}

}  // namespace

void add_distribution(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("distribution", "Coefficients of restitution of bodies that vibrate at random");
  auto arguments = std::make_shared<DistributionArguments>();
  arguments->who.first.add_poisson_to(*command);
  add(*command, "--speed", arguments->speed, "Speed of approach, 1e-8 to 1 in c of the body (with a material: m/s)",
      "V", "Body")
      ->required();
  arguments->who.add_to(*command);
  add_ensemble(*command, *arguments);
  arguments->rows.add_to(*command);
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
