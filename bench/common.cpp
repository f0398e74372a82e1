#include "common.hpp"

#include <cmath>
#include <map>

#include "stoss/bodies/disk.hpp"

namespace bench {

const stoss::Body& disk_body(double cutoff) {
  static std::map<double, stoss::Body> bodies;
  auto found = bodies.find(cutoff);
  if (found == bodies.end()) found = bodies.emplace(cutoff, stoss::disk(poisson, cutoff)).first;
  return found->second;
}

void count(benchmark::State& state, double lost_fraction) {
  state.counters[lost_fraction_counter] = lost_fraction;
  state.counters[error_counter] = std::abs(lost_fraction - converged_lost_fraction);
}

}  // namespace bench
