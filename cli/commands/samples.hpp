#pragma once

#include <string>
#include <vector>

#include "output/fields.hpp"
#include "output/row_run.hpp"
#include "stoss/vibration/distribution.hpp"

namespace stoss::cli {

/// The impacts of `stoss distribution`.
struct Ensemble {
  RefinableContact contact;
  double speed = 0.0;  ///< c
  Spectrum spectrum;
  DistributionOptions options;  ///< but where a run is resumed
  Units units;
};

/// What rows the samples of an ensemble make; `taken` gets each of them.
[[nodiscard]] RowPlan sample_plan(const Ensemble& ensemble, std::vector<Sample>& taken);

/// Computes the samples that the run does not have yet. @throws Interrupted, OutputError
void compute_samples(const Ensemble& ensemble, RowRun& run);

/// The summary of samples in two or three lines for reading, with line ends.
[[nodiscard]] std::string summary_lines(const DistributionSummary& summary);

}  // namespace stoss::cli
