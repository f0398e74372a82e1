#include "restitution/missing_energy.hpp"

#include <algorithm>
#include <cmath>

#include "restitution/calibration.hpp"

namespace stoss {
namespace {

/// Shares rise at low speed, and fall at high speed, where errors have either sign: they fall less than their mean.
double whole_share(const calibration::Share& share, double cutoff, double speed) {
  using namespace calibration;
  return share.at_64 * std::pow(64.0 / cutoff, share.power) *
         std::clamp(std::pow(speed / slow_speed, slow_power), 1.0, slow_at_most);
}

Missing missing(double whole, const calibration::Share& mean, double speed, const Term& noise, const Term& fast) {
  const double share = whole * (1.0 / (1.0 + speed / mean.half)), of_share = calibration::of_share * share;
  const double slow = of_share + noise.error;
  if (fast.error > slow) return {share, fast};
  if (of_share > noise.error) return {share, {"of_share", calibration::of_share, slow}};
  return {share, {noise.constant, noise.in_use, slow}};
}

}  // namespace

Missing missing_on_a_line(double cutoff, double speed) {
  using namespace calibration;
  const auto& [at_16, power, slow] = noise_on_a_line;
  const double whole = whole_share(share_on_a_line, cutoff, speed), calm = std::min(2.2, std::pow(speed / slow, -0.25));
  const double noise = at_16 * calm * std::pow(16.0 / cutoff, power);
  const double either = std::min(std::pow(speed / fast_speed, 4), fast_at_most);
  return missing(whole, share_on_a_line, speed, {"noise_on_a_line.at_16", at_16, noise},
                 {"fast_at_most", fast_at_most, either * whole});
}

Missing missing_of_balls(double cutoff, double speed, double hole) {
  using namespace calibration;
  const auto& [at_16, power, slow] = noise_of_balls;
  const double whole = whole_share(share_of_balls, cutoff, speed);
  const double calm = std::max(std::min(std::pow(speed / slow, -0.4), 16.0), std::pow(speed / slow, -0.25));
  const double noise = at_16 * calm * 16.0 / std::pow(cutoff, power);
  Missing its = missing(whole, share_of_balls, speed, {"noise_of_balls.at_16", at_16, noise},
                        {"fast_of_balls", fast_of_balls, fast_of_balls * whole});
  const double shell = share_of_shells * std::pow(hole, 6);
  if (shell > its.doubt.error) its.doubt = {"share_of_shells", share_of_shells, its.doubt.error};
  its.doubt.error += shell;
  return its;
}

}  // namespace stoss
