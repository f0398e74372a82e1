#include "stoss/bodies/sphere/modes.hpp"

#include "bodies/mode_search.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "bodies/sphere/radial_field.hpp"
#include "check.hpp"
#include "quantity_help.hpp"

namespace stoss::bodies::sphere {
namespace {

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
  constexpr double above_the_lowest = 3.0;  // which lies between 1.3 and 1.9 for every ν
  if (modes.empty()) refuse_low_cutoff(find_modes(poisson, above_the_lowest, {}), cutoff, max_cutoff);
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

const Quantities<Mode>& mode_quantities() {
  using enum Dimension;
  static const Quantities<Mode> all{
      {"order", none, help::order, &Mode::order},
      {"index", none, help::index, &Mode::index},
      {"omega", frequency, help::omega, &Mode::omega},
      {"radial", none, help::radial, &Mode::radial},
      {"tangential", none, help::tangential, &Mode::tangential},
  };
  return all;
}

}  // namespace stoss::bodies::sphere
