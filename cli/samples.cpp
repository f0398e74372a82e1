#include "samples.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "csv.hpp"
#include "estimate.hpp"
#include "interrupt.hpp"
#include "tables.hpp"

namespace stoss::cli {
namespace {

Record record_of(const Ensemble& ensemble, const Sample& sample) {
  Record record;
  add_quantities(record, sample_table(), sample, ensemble.units);
  return record;
}

double number(const std::string& cell) {
  return cell == unknown ? std::numeric_limits<double>::infinity() : std::stod(cell);
}

/// A sample as its row has it, as far as a summary needs it.
Sample sample_of(const Cells& cells) {
  const auto estimate = [&cells](const std::string& name) {
    return Estimate{number(cells.at(name)), number(cells.at(name + "_error"))};
  };
  Sample sample;
  sample.restitution = estimate("restitution");
  sample.lost_fraction = estimate("lost_fraction");
  sample.converged = cells.at("converged") == "true";
  return sample;
}

std::string with_both_errors(const Mean& mean) {
  const auto error = [](double value) { return std::isfinite(value) ? fmt::format("{:.1e}", value) : "unknown"; };
  return fmt::format("{:.8g} ± {} (statistical) ± {} (numerical)", mean.value, error(mean.statistical_error),
                     error(mean.numerical_error));
}

}  // namespace

Rows sample_rows(const Ensemble& ensemble, std::vector<Sample>& taken) {
  return {.size = static_cast<std::size_t>(ensemble.options.samples),
          .columns = csv_columns(record_of(ensemble, {})),
          .key =
              [](std::size_t row) {
                return Record{{"sample", "", static_cast<long>(row)}};
              },
          .name = [](std::size_t row) { return fmt::format("sample {}", row); },
          .observer = [&taken](const Cells& cells) { taken.push_back(sample_of(cells)); }};
}

void compute_samples(const Ensemble& ensemble, Sweep& sweep, Report& report) {
  if (sweep.done() == sweep.size()) return;
  DistributionOptions options = ensemble.options;
  options.first = static_cast<long>(sweep.done());
  options.samples -= options.first;
  options.poll = [&sweep] {
    heed_interrupts();
    sweep.wait(fmt::format("sample {}", sweep.done()));
  };
  restitution_distribution(ensemble.contact, ensemble.speed, ensemble.spectrum, options, [&](const Sample& sample) {
    heed_interrupts();
    Row row{.record = record_of(ensemble, sample), .trouble = sample.converged ? "" : sample.reason};
    if (!sample.converged) row.details["reason"] = sample.reason;
    sweep.add(row, report);
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
