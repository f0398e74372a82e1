#include "prediction/waves.hpp"

#include <algorithm>

namespace stoss::prediction {

double waves_of(const Restitution& its) {
  return std::max(its.lost_fraction.value - its.dissipated - its.yielded, 0.0);
}

double radiated(const Restitution& its, bool block) {
  if (!block) return 0.0;
  double ring = its.lost_to_first, run = its.lost_to_second;
  if (its.dissipated > 0.0 || its.yielded > 0.0) {
    ring = run = 0.0;
    for (const ModeEnergy& mode : its.finest.energy.modes) (mode.body == 0 ? ring : run) += mode.after;
  }
  return ring + run > 0.0 ? waves_of(its) * run / (ring + run) : 0.0;
}

}  // namespace stoss::prediction
