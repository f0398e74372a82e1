#include "stoss/modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <sstream>
#include <string>

#include "bessel.hpp"
#include "check.hpp"
#include "edge_problem.hpp"
#include "mode_search.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

void require_poisson(double poisson) {
  constexpr Range allowed{min_poisson, max_poisson, true, true, "-0.95 to 0.995"};
  require("poisson", poisson, allowed,
          "2-D Poisson number, plane stress; for plane strain pass nu/(1-nu) of the material");
}

[[noreturn]] void refuse_low_cutoff(double poisson, double cutoff) {
  const auto lowest = find_modes(poisson, 2.0);  // the lowest mode lies between 1.1 and 1.8 for every ν
  const auto first =
      std::min_element(lowest.begin(), lowest.end(), [](const Mode& a, const Mode& b) { return a.omega < b.omega; });
  std::ostringstream line;
  line.precision(6);
  line << "cutoff: got " << cutoff << ", allowed " << first->omega << " to " << max_cutoff
       << " (below the lowest mode nothing vibrates; 25 to 100 is usual)";
  throw InvalidInput(line.str());
}

/// The static sum rules (docs/theory.md): what the modes of one order leave of its flexibility must be positive
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

/// Ratio of the same Bessel function at two arguments, given as scaled pairs.
struct Ratio {
  double value;  // J_n(κr)/J_n(κ) times the edge value
  double next;
};

Ratio rescaled(const BesselPair& inside, const BesselPair& edge) {
  const int shift = inside.exponent - edge.exponent;
  return {std::ldexp(inside.value, shift), std::ldexp(inside.next, shift)};
}

}  // namespace

ModeFamily family(const Mode& mode) {
  return mode.radial > std::abs(mode.tangential) ? ModeFamily::radial : ModeFamily::tangential;
}

std::vector<Mode> disk_modes(double poisson, double cutoff) {
  require_poisson(poisson);
  constexpr Range allowed{0.0, max_cutoff, false, true, "the lowest mode (about 1.4) to 1000"};
  require("cutoff", cutoff, allowed, "highest frequency in c/R; 25 to 100 is usual");
  auto modes = find_modes(poisson, cutoff);
  if (modes.empty()) refuse_low_cutoff(poisson, cutoff);
  check_sum_rules(poisson, cutoff, modes);
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
  // u = (r_low r^p + r_high r^q, t_low r^p + t_high r^q) under unit tractions σ_rr and σ_rφ (Michell's solution;
  // for n = 1 with inertia relief: p = 0, q = 2).
  struct Field {
    double radial_low, radial_high, tangential_low, tangential_high;
  };
  const auto field = [&](double normal, double shear) -> Field {
    if (order == 1) {
      const double b = 0.25 * (normal + shear), g = normal - shear;
      const double radial = (1.0 - 3.0 * poisson) * b + 0.25 * (1.0 + poisson) * g;
      const double tangential = (5.0 + poisson) * b - 0.75 * (1.0 + poisson) * g;
      const double shift = 0.25 * (tangential - radial);
      return {shift, radial, -shift, tangential};
    }
    const double b = 0.5 * (normal + shear) / (n + 1.0);
    const double low = (1.0 + poisson) * ((2.0 - n) * shear - n * normal) / (2.0 * (n - 1.0));
    return {-low, -((n - 2.0) + poisson * (n + 2.0)) * b, low, (n + 4.0 + poisson * n) * b};
  };
  const auto product = [&](const Field& x, const Field& y) {
    const double low = x.radial_low * y.radial_low + x.tangential_low * y.tangential_low;
    const double mixed = x.radial_low * y.radial_high + x.radial_high * y.radial_low +
                         x.tangential_low * y.tangential_high + x.tangential_high * y.tangential_low;
    const double high = x.radial_high * y.radial_high + x.tangential_high * y.tangential_high;
    return low / (2.0 * n) + mixed / (2.0 * n + 2.0) + high / (2.0 * n + 4.0);
  };
  const Field normal = field(1.0, 0.0), shear = field(0.0, 1.0);
  return {product(normal, normal), product(normal, shear), product(shear, shear)};
}

std::vector<Displacement> displacement(double poisson, const Mode& mode, const std::vector<double>& radii) {
  require_poisson(poisson);
  require("order", static_cast<long>(mode.order), 0, 1'000'000, "angular order of the mode");
  require("omega", mode.omega, {0.0, max_cutoff, false, true, "above 0 and up to 1000"},
          "frequency of the mode in c/R");
  constexpr Range inside{0.0, 1.0, true, true, "0 to 1"};
  for (const double radius : radii) require("radius", radius, inside, "in units of the radius of the disk");
  const double kappa = std::sqrt(1.0 - poisson * poisson) * mode.omega;
  const double kappa_shear = std::sqrt(2.0 * (1.0 + poisson)) * mode.omega;
  const int n = mode.order;
  const auto order = static_cast<std::size_t>(n);

  std::vector<BesselPair> pairs(order + 1);
  bessel_pairs(kappa, pairs);
  const BesselPair pressure = pairs.back();
  bessel_pairs(kappa_shear, pairs);
  const BesselPair shear = pairs.back();
  double a = -mode.radial / pressure.next;  // n = 0: u_r = A κ J_0'(κr)
  double b = 0.0;
  if (n > 0) {
    const auto vibration = EdgeProblem{n, kappa, kappa_shear, pressure, shear}.vibration();
    a = vibration.pressure;
    b = vibration.shear;
  }

  std::vector<Displacement> field;
  field.reserve(radii.size());
  for (const double radius : radii) {
    // J_n(κr)/r → κ/2 δ_{n1} at the centre: evaluate just beside it.
    const double r = std::max(radius, 1e-30);
    bessel_pairs(kappa * r, pairs);
    const Ratio p = rescaled(pairs.back(), pressure);
    bessel_pairs(kappa_shear * r, pairs);
    const Ratio s = rescaled(pairs.back(), shear);
    const double sum = n * (a * p.value + b * s.value);
    field.push_back({(sum - a * p.next) / r, (b * s.next - sum) / r});
  }
  return field;
}

}  // namespace stoss
