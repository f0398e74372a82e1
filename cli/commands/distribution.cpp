// stoss distribution: the coefficient of restitution of many bodies that vibrate at random.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/output_options.hpp"
#include "output/row_run.hpp"
#include "process/process.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"
#include "stoss/vibration/quantities.hpp"

namespace stoss::cli {
namespace {

struct DistributionArguments {
  EncounterOptions who;
  SpectrumArguments spectrum;
  ApproachOptions approach;
  int samples = 1000;
  int seed = 0;
  double error = 1e-3;
  int threads = 0;
  RowOptions rows;
  CLI::App* command = nullptr;
};

/// The impacts.
struct Ensemble {
  RefinableContact contact;
  double speed = 0.0;  ///< c
  Spectrum spectrum;
  DistributionOptions options;  ///< but where a run is resumed
  Units units;
};

Ensemble make_ensemble(DistributionArguments& arguments, const Encounter& encounter) {
  const Units units = units_of(encounter);
  const double speed = arguments.approach.one(units);
  RefinableContact contact = refinable(encounter);
  const Poll poll = waiting(arguments.rows.output, "modes that vibrate");
  Spectrum spectrum = arguments.spectrum.spectrum(contact, poll);
  if (arguments.seed < 0) {
    throw InvalidInput::out_of_range("seed", fmt::format("{}", arguments.seed), "0 to 2147483647",
                                     "another one, another ensemble");
  }
  const DistributionOptions options{.samples = arguments.samples,
                                    .seed = static_cast<std::uint64_t>(arguments.seed),
                                    .error = arguments.error,
                                    .threads = arguments.threads,
                                    .poll = poll};
  Ensemble ensemble{std::move(contact), speed, std::move(spectrum), options, units};
  validate(ensemble.contact, ensemble.speed, ensemble.spectrum, ensemble.options);
  ensemble.options.poll = heed_interrupts;  // rows say themselves what they do
  return ensemble;
}

Provenance describe(const DistributionArguments& arguments, const Encounter& encounter, const Ensemble& ensemble) {
  Provenance its = provenance(*arguments.command, encounter);
  arguments.spectrum.describe(its.inputs);
  its.inputs["modes"] = ensemble.spectrum.size();
  return its;
}

Fields<Sample> sample_fields(const Units& units) {
  return Fields<Sample>(sample_quantities(), units,
                        {{"sample", {.width = 8}},
                         {"vibration", {.width = 13}},
                         {"restitution", {.width = 22, .with_error = true}},
                         {"lost_fraction", {.width = 25, .with_error = true, .mark = {{"converged", false}}}},
                         {"contact_time", {.width = 13, .si_width = 17}}});
}

/// A sample as its row has it, as far as a summary needs it.
Sample sample_of(const Columns& columns, const Row& row) {
  const auto estimate = [&](const std::string& name) {
    return Estimate{number(*find(columns, row, name)), number(*find(columns, row, name + "_error"))};
  };
  Sample sample;
  sample.restitution = estimate("restitution");
  sample.lost_fraction = estimate("lost_fraction");
  sample.converged = has(columns, row, "converged", true);
  return sample;
}

std::string with_both_errors(const Mean& mean) {
  const auto error = [](double value) { return std::isfinite(value) ? fmt::format("{:.1e}", value) : "unknown"; };
  return fmt::format("{:.8g} ± {} (statistical) ± {} (numerical)", mean.value, error(mean.statistical_error),
                     error(mean.numerical_error));
}

/// What rows the samples of an ensemble make; `taken` gets each of them.
RowPlan sample_plan(const Ensemble& ensemble, std::vector<Sample>& taken) {
  const Columns columns = sample_fields(ensemble.units).columns();
  return {.size = static_cast<std::size_t>(ensemble.options.samples),
          .columns = columns,
          .key = [](std::size_t row) { return Row{static_cast<std::int64_t>(row)}; },
          .name = [](std::size_t row) { return fmt::format("sample {}", row); },
          .observer = [&taken, columns](const Row& row) { taken.push_back(sample_of(columns, row)); }};
}

/// Computes the samples that the run does not have yet. @throws Interrupted, OutputError
void compute_samples(const Ensemble& ensemble, RowRun& run) {
  DistributionOptions options = ensemble.options;
  options.first = static_cast<std::int64_t>(run.done());
  options.samples -= options.first;
  if (options.samples == 0) return;
  options.poll = [&run] {
    heed_interrupts();
    run.wait(fmt::format("sample {}", run.done()));
  };
  const Fields<Sample> its = sample_fields(ensemble.units);
  restitution_distribution(ensemble.contact, ensemble.speed, ensemble.spectrum, options, [&](const Sample& sample) {
    heed_interrupts();
    auto details = nlohmann::ordered_json::object();
    if (!sample.converged) details["reason"] = sample.reason;
    run.add(its.row(sample), details, sample.converged ? "" : sample.reason);
  });
}

/// The summary of samples in two or three lines for reading, with line ends.
std::string summary_lines(const DistributionSummary& summary) {
  std::string text = fmt::format("mean restitution      {}\nmean lost fraction    {}\n",
                                 with_both_errors(summary.restitution), with_both_errors(summary.lost_fraction));
  if (std::isfinite(summary.standard_deviation)) {
    text += fmt::format("standard deviation    {:.4g} of the restitution\n", summary.standard_deviation);
  }
  text += fmt::format("minimum and maximum   {:.8g}, {:.8g}\nabove 1               {:.4g} % of {} samples\n",
                      summary.least, summary.greatest, 100.0 * summary.share_above_one, summary.samples);
  if (summary.missing > 0) text += fmt::format("without a value       {} samples\n", summary.missing);
  return text;
}

/// The summary as JSON has it.
nlohmann::ordered_json summary_json(const DistributionSummary& all) {
  auto object = to_json(distribution_quantities(), std::vector{all}).front();
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
  if (format == Format::json) writer.attach("summary", summary_json(all));
  if (format == Format::table) writer.close_table("\n" + lines);
  if (format == Format::csv && !output.quiet) show(lines);
}

void run(const DistributionArguments& asked) {
  DistributionArguments arguments = asked;
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
  warn_of_materials(output, encounter, ensemble.speed);
  run.conclude();
}

void add_ensemble(CLI::App& command, DistributionArguments& arguments) {
  arguments.spectrum.add_to(command);
  add_input(command, Question::distribution, "samples", arguments.samples, "Ensemble");
  add_input(command, Question::distribution, "seed", arguments.seed, "Ensemble");
  add_input(command, Question::distribution, "error", arguments.error, "Resolution");
  add_threads(command, arguments.threads);
}

}  // namespace

void add_distribution(CLI::App& app) {
  auto& arguments = add_subcommand<DistributionArguments>(
      app, "distribution", "Coefficients of restitution of bodies that vibrate at random", run,
      "Examples:\n"
      "  stoss distribution --body sphere --poisson 0.3 --speed 0.01 --temperature 0.01 --seed 7\n"
      "  stoss distribution --body sphere --poisson 0.3 --speed 0.01 --temperature 0.01 --highest 20\n"
      "      --samples 1e4 --resume samples.csv\n"
      "  stoss distribution --body rod --speed 0.1 --against rod,length=2.5 --temperature 0.02 --error 0.02\n"
      "  stoss distribution --body disk --poisson 0.33 --speed 0.1 --spectrum 2,0,energy=0.1 --format json");
  CLI::App& command = *arguments.command;
  arguments.who.first.add_poisson_to(command);
  arguments.approach.add_to(command, Question::distribution, "Motion");
  arguments.who.add_to(command);
  add_ensemble(command, arguments);
  arguments.rows.add_to(command);
}

}  // namespace stoss::cli
