#include "stoss/bodies/disk/modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <sstream>
#include <string>

#include "bodies/disk/mode_field.hpp"
#include "bodies/disk/mode_search.hpp"
#include "bodies/disk/static_field.hpp"
#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::disk {
namespace {

[[noreturn]] void refuse_low_cutoff(double poisson, double cutoff) {
  const auto lowest = find_modes(poisson, 2.0, {});  // the lowest mode lies between 1.1 and 1.8 for every ν
  const auto first =
      std::min_element(lowest.begin(), lowest.end(), [](const Mode& a, const Mode& b) { return a.omega < b.omega; });
  std::ostringstream line;
  line.precision(6);
  line << "cutoff: got " << cutoff << ", allowed " << first->omega << " to " << max_cutoff
       << " (below the lowest mode nothing vibrates; 25 to 100 is usual)";
  throw InvalidInput(line.str());
}

/// The static sum rules (docs/theory/modes.md): what the modes of one order leave of its flexibility must be positive
/// semidefinite and no larger than the modes above the cutoff can carry, about (2/πω_c)(κ + κ′)/ω.
void check_sum_rule(double poisson, double cutoff, int order, const Flexibility& kept) {
  const Flexibility all = static_flexibility(poisson, order);
  const double radial = all.radial - kept.radial;
  const double mixed = all.mixed - kept.mixed;
  const double tangential = all.tangential - kept.tangential;
  const double lowest = 0.5 * (radial + tangential) - std::hypot(0.5 * (radial - tangential), mixed);
  const double rounding = 1e-12 * (all.radial + all.tangential);
  const double tail =
      2.0 / (std::numbers::pi * cutoff) * (std::sqrt(1.0 - poisson * poisson) + std::sqrt(2.0 * (1.0 + poisson)));
  if (lowest < -rounding || radial + tangential > 1.5 * tail + 4.0 / (cutoff * cutoff)) {
    throw NotConverged("modes: the static sum rule of order " + std::to_string(order) + " is violated");
  }
}

void check_sum_rules(double poisson, double cutoff, const std::vector<Mode>& modes) {
  auto mode = modes.begin();
  for (int order = 0; order <= modes.back().order; ++order) {
    Flexibility kept;
    for (; mode != modes.end() && mode->order == order; ++mode) {
      const double compliance = 1.0 / (mode->omega * mode->omega);
      kept.radial += mode->radial * mode->radial * compliance;
      kept.mixed += mode->radial * mode->tangential * compliance;
      kept.tangential += mode->tangential * mode->tangential * compliance;
    }
    check_sum_rule(poisson, cutoff, order, kept);
  }
}

}  // namespace

ModeFamily family(const Mode& mode) {
  return mode.radial > std::abs(mode.tangential) ? ModeFamily::radial : ModeFamily::tangential;
}

std::vector<Mode> modes(double poisson, double cutoff, const Poll& poll) {
  require_poisson(poisson);
  constexpr Range allowed{0.0, max_cutoff, false, true, "the lowest mode (about 1.4) to 1000"};
  require("cutoff", cutoff, allowed, "highest frequency in c/R; 25 to 100 is usual");
  auto modes = checked_modes(poisson, cutoff, poll);
  if (modes.empty()) refuse_low_cutoff(poisson, cutoff);
  return modes;
}

std::vector<Mode> checked_modes(double poisson, double cutoff, const Poll& poll) {
  auto modes = find_modes(poisson, cutoff, poll);
  if (!modes.empty()) check_sum_rules(poisson, cutoff, modes);
  return modes;
}

Flexibility static_flexibility(double poisson, int order) {
  require_poisson(poisson);
  require("order", order, 0L, 100'000'000L, "angular order");
  const double soft = 1.0 - poisson;
  if (order == 0) return {0.5 * soft, 0.0, 0.0};
  if (order == 1) return {0.5 * soft, 0.5 * soft, 0.5 * (3.0 + poisson)};
  const double n = order;
  const double denominator = (n - 1.0) * (n + 1.0);
  return {(2.0 * n - soft) / denominator, (n * soft - 2.0) / denominator, (2.0 * n - soft) / denominator};
}

Flexibility static_second_moment(double poisson, int order) {
  require_poisson(poisson);
  require("order", order, 0L, 100'000'000L, "angular order");
  const double soft = 1.0 - poisson;
  if (order == 0) return {0.125 * soft * soft, 0.0, 0.0};
  const double n = order;
  const auto product = [n](const StaticField& x, const StaticField& y) {
    const double low = x.radial_low * y.radial_low + x.tangential_low * y.tangential_low;
    const double mixed = x.radial_low * y.radial_high + x.radial_high * y.radial_low +
                         x.tangential_low * y.tangential_high + x.tangential_high * y.tangential_low;
    const double high = x.radial_high * y.radial_high + x.tangential_high * y.tangential_high;
    return low / (2.0 * n) + mixed / (2.0 * n + 2.0) + high / (2.0 * n + 4.0);
  };
  const StaticField normal = static_field(poisson, order, 1.0, 0.0), shear = static_field(poisson, order, 0.0, 1.0);
  return {product(normal, normal), product(normal, shear), product(shear, shear)};
}

std::vector<Displacement> displacement(double poisson, const Mode& mode, const std::vector<double>& radii,
                                       const Poll& poll) {
  std::vector<Displacement> field;
  field.reserve(radii.size());
  for (const RadialField& at : mode_field(poisson, mode, radii, poll)) field.push_back({at.radial, at.tangential});
  return field;
}

}  // namespace stoss::bodies::disk
