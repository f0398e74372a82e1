#pragma once

#include <vector>

namespace validate {

/// Processor time of one call of restitution(), without that of making modes.
struct Time {
  double poisson = 0.0;
  double speed = 0.0;
  double seconds = 0.0;
  bool converged = false;
  double cutoff = 0.0;  ///< of the finest impact, c/R
};

using Times = std::vector<Time>;

/// Times at each of the tolerances over the whole range of Poisson's ratios and speeds.
std::vector<Times> measure_times(const std::vector<double>& tolerances);

}  // namespace validate
