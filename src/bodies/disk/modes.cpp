#include "stoss/bodies/disk/modes.hpp"

#include <cmath>
#include <string>

#include "bodies/disk/mode_search.hpp"
#include "bodies/disk/radial_field.hpp"
#include "bodies/mode_search.hpp"
#include "check.hpp"
#include "quantity_help.hpp"

namespace stoss::bodies::disk {

ModeFamily family(const Mode& mode) {
  return mode.radial > std::abs(mode.tangential) ? ModeFamily::radial : ModeFamily::tangential;
}

std::vector<Mode> modes(double poisson, double cutoff, const Poll& poll) {
  require_poisson(poisson);
  constexpr Range allowed{0.0, max_cutoff, false, true, "the lowest mode (about 1.4) to 1000"};
  require("cutoff", cutoff, allowed, "highest frequency in c/R; 25 to 100 is usual");
  auto modes = checked_modes(poisson, cutoff, poll);
  constexpr double above_the_lowest = 2.0;  // which lies between 1.1 and 1.8 for every ν
  if (modes.empty()) refuse_low_cutoff(find_modes(poisson, above_the_lowest, {}), cutoff, max_cutoff);
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

const Quantities<Mode>& mode_quantities() {
  using enum Dimension;
  const auto family_name = [](const Mode& mode) {
    return std::string(family(mode) == ModeFamily::radial ? "radial" : "tangential");
  };
  static const Quantities<Mode> all{
      {"order", none, help::order, &Mode::order},
      {"index", none, help::index, &Mode::index},
      {"omega", frequency, help::omega, &Mode::omega},
      {"radial", none, help::radial, &Mode::radial},
      {"tangential", none, help::tangential, &Mode::tangential},
      {"family", none, "Family of the mode, radial or tangential by its larger amplitude at the edge", family_name},
  };
  return all;
}

}  // namespace stoss::bodies::disk
