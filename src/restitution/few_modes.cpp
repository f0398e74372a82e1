#include "restitution/few_modes.hpp"

#include <algorithm>
#include <cmath>

#include "restitution/calibration.hpp"

namespace stoss {

bool has_few_modes(const Contact& contact) {
  return is_known_at_a_point(*contact.first) || (contact.second && is_known_at_a_point(*contact.second));
}

Term doubt_of_few_modes(const std::vector<Run>& runs, double scale, double speed) {
  const calibration::FewModes& its = calibration::few_modes;
  const double cutoff = runs.back().cutoff;
  double unresolved = 0.0;
  for (const Run& run : runs) {
    const double ratio = run.cutoff / cutoff;
    unresolved = std::max(unresolved, std::abs(run.unresolved) * ratio * ratio);
  }
  const double slow = std::max(std::pow(speed / its.speed, -its.speed_power), its.fast);
  const double share = std::min(its.at_4 * std::pow(4.0 / (cutoff * scale), its.power) * slow, its.most);
  return {"few_modes.at_4", its.at_4, share * unresolved};
}

}  // namespace stoss
