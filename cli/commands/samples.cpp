#include "commands/samples.hpp"

#include <fmt/format.h>

#include <cmath>

#include "process/interrupt.hpp"
#include "stoss/vibration/quantities.hpp"

namespace stoss::cli {
namespace {

Fields<Sample> fields(const Units& units) {
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

}  // namespace

RowPlan sample_plan(const Ensemble& ensemble, std::vector<Sample>& taken) {
  const Columns columns = fields(ensemble.units).columns();
  return {.size = static_cast<std::size_t>(ensemble.options.samples),
          .columns = columns,
          .key = [](std::size_t row) { return Row{static_cast<long>(row)}; },
          .name = [](std::size_t row) { return fmt::format("sample {}", row); },
          .observer = [&taken, columns](const Row& row) { taken.push_back(sample_of(columns, row)); }};
}

void compute_samples(const Ensemble& ensemble, RowRun& run) {
  if (run.done() == run.size()) return;
  DistributionOptions options = ensemble.options;
  options.first = static_cast<long>(run.done());
  options.samples -= options.first;
  options.poll = [&run] {
    heed_interrupts();
    run.wait(fmt::format("sample {}", run.done()));
  };
  const Fields<Sample> its = fields(ensemble.units);
  restitution_distribution(ensemble.contact, ensemble.speed, ensemble.spectrum, options, [&](const Sample& sample) {
    heed_interrupts();
    auto details = nlohmann::ordered_json::object();
    if (!sample.converged) details["reason"] = sample.reason;
    run.add(its.row(sample), details, sample.converged ? "" : sample.reason);
  });
}

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

}  // namespace stoss::cli
