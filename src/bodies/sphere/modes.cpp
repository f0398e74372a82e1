#include "stoss/bodies/sphere/modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <sstream>
#include <string>

#include "bodies/sphere/mode_field.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "bodies/sphere/static_field.hpp"
#include "bodies/sphere/static_flexibility.hpp"
#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::sphere {
namespace {

[[noreturn]] void refuse_low_cutoff(double poisson, double cutoff) {
  const auto lowest = find_modes(poisson, 3.0, {});  // the lowest mode lies between 1.3 and 1.9 for every ν
  const auto first =
      std::min_element(lowest.begin(), lowest.end(), [](const Mode& a, const Mode& b) { return a.omega < b.omega; });
  std::ostringstream line;
  line.precision(6);
  line << "cutoff: got " << cutoff << ", allowed " << first->omega << " to " << max_cutoff
       << " (below the lowest mode nothing vibrates; 25 to 100 is usual)";
  throw InvalidInput(line.str());
}

/// The static sum rules (docs/theory/spheres.md): what the modes of one degree leave of its flexibility must be
/// positive semidefinite and no larger than the modes above the cutoff can carry, about (2n+1)/3 (2/πω_c)(1/c_p +
/// 1/c_s).
void check_sum_rule(double poisson, double cutoff, int order, const Flexibility& kept) {
  const Flexibility all = static_flexibility(poisson, order);
  const double radial = all.radial - kept.radial;
  const double mixed = all.mixed - kept.mixed;
  const double tangential = all.tangential - kept.tangential;
  const double lowest = 0.5 * (radial + tangential) - std::hypot(0.5 * (radial - tangential), mixed);
  const double rounding = 1e-11 * (all.radial + all.tangential);
  const WaveSpeeds speed = wave_speeds(poisson);
  const double tail =
      (2.0 * order + 1.0) / 3.0 * 2.0 / (std::numbers::pi * cutoff) * (1.0 / speed.pressure + 1.0 / speed.shear);
  if (lowest < -rounding || radial + tangential > 1.5 * tail + 4.0 / (cutoff * cutoff)) {
    throw NotConverged("modes: the static sum rule of degree " + std::to_string(order) + " is violated");
  }
}

/// Products of the static fields of unit loads, ∫ r² (u_r u_r + L u_θ u_θ) dr.
double product(double n, const StaticField& x, const StaticField& y) {
  const double wave = n * (n + 1.0);
  const auto dot = [wave](double r, double t, double s, double u) { return r * s + wave * t * u; };
  const double low = dot(x.radial_low, x.tangential_low, y.radial_low, y.tangential_low);
  const double mixed = dot(x.radial_low, x.tangential_low, y.radial_high, y.tangential_high) +
                       dot(x.radial_high, x.tangential_high, y.radial_low, y.tangential_low);
  const double high = dot(x.radial_high, x.tangential_high, y.radial_high, y.tangential_high);
  return low / (2.0 * n + 1.0) + mixed / (2.0 * n + 3.0) + high / (2.0 * n + 5.0);
}

}  // namespace

std::vector<Mode> modes(double poisson, double cutoff, const Poll& poll) {
  require_poisson(poisson);
  constexpr Range allowed{0.0, max_cutoff, false, true, "the lowest mode (about 1.6) to 1000"};
  require("cutoff", cutoff, allowed, "highest frequency in c/R; 25 to 100 is usual");
  auto modes = checked_modes(poisson, cutoff, poll);
  if (modes.empty()) refuse_low_cutoff(poisson, cutoff);
  return modes;
}

std::vector<Mode> checked_modes(double poisson, double cutoff, const Poll& poll) {
  auto modes = find_modes(poisson, cutoff, poll);
  if (modes.empty()) return modes;
  auto mode = modes.cbegin();
  for (int order = 0; order <= modes.back().order; ++order) {
    Flexibility kept;
    for (; mode != modes.cend() && mode->order == order; ++mode) {
      const double compliance = 1.0 / (mode->omega * mode->omega);
      kept.radial += mode->radial * mode->radial * compliance;
      kept.mixed += mode->radial * mode->tangential * compliance;
      kept.tangential += mode->tangential * mode->tangential * compliance;
    }
    check_sum_rule(poisson, cutoff, order, kept);
  }
  return modes;
}

Flexibility static_flexibility(double poisson, int order) {
  require_poisson(poisson);
  require("order", order, 0L, 100'000'000L, "degree");
  const double incompressible = 1.0 - 2.0 * poisson;  // 0 there
  if (order == 0) return {incompressible / 3.0, 0.0, 0.0};
  if (order == 1) return {0.6 * incompressible, -0.4 * incompressible, 0.2 * (3.0 - poisson)};
  return flexibility_of_degree(poisson, order);
}

Flexibility static_second_moment(double poisson, int order) {
  require_poisson(poisson);
  require("order", order, 0L, 100'000'000L, "degree");
  if (order == 0) return {(1.0 - 2.0 * poisson) * (1.0 - 2.0 * poisson) / 15.0, 0.0, 0.0};
  const double n = order;
  const double unit = (2.0 * n + 1.0) / 3.0;
  const StaticField normal = static_field(poisson, order, 1.0, 0.0);
  const StaticField shear = static_field(poisson, order, 0.0, 1.0 / (n * (n + 1.0)));
  return {unit * product(n, normal, normal), unit * product(n, normal, shear), unit * product(n, shear, shear)};
}

std::vector<Displacement> displacement(double poisson, const Mode& mode, const std::vector<double>& radii,
                                       const Poll& poll) {
  std::vector<Displacement> field;
  field.reserve(radii.size());
  for (const RadialField& at : mode_field(poisson, mode, radii, poll)) field.push_back({at.radial, at.tangential});
  return field;
}

}  // namespace stoss::bodies::sphere
