#include "bodies/sphere/along/toroidal.hpp"

#include <cmath>
#include <cstddef>

#include "bodies/mode_search.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "numeric/bessel.hpp"

namespace stoss::bodies::sphere {
namespace {

/// The free surface for one degree n ≥ 1, as modes_by_order searches it: κ and κ′ are the same, and so are both pairs.
struct ToroidalEdge {
  using Mode = ToroidalMode;
  static constexpr auto bessel = numeric::BesselKind::spherical;

  int order;
  double kappa, kappa_shear;
  numeric::BesselPair pressure, shear;  // (j_n, κ′ j_{n+1})

  [[nodiscard]] double determinant() const { return (order - 1.0) * shear.value - shear.next; }
  [[nodiscard]] double shear_pole() const { return shear.value; }

  /// @param poles zeros of j_n, each counted twice
  [[nodiscard]] int roots_below(int poles) const {
    const int passed = opposite(determinant(), shear.value) ? 1 : 0;  // the root of this interval
    const int rigid = order == 1 ? 1 : 0;
    return poles / 2 + passed - rigid;
  }

  [[nodiscard]] ToroidalMode mode(int index, double omega) const {
    const double n = order, square = kappa_shear * kappa_shear;
    const double norm = (2.0 * n + 1.0) / (3.0 * n * (n + 1.0)) * 2.0 * square / (square - (n - 1.0) * (n + 2.0));
    return {order, index, omega, std::sqrt(norm)};
  }
};

}  // namespace

std::vector<ToroidalMode> toroidal_modes(double poisson, double cutoff, const Poll& poll) {
  // κ′ > n of the first root of n ≥ 2, and above 2 of all.
  const double per_omega = 1.0 / wave_speeds(poisson).shear;
  constexpr double none_below = 2.0;
  std::vector<ToroidalMode> modes;
  if (per_omega * cutoff <= none_below) return modes;
  const auto orders = static_cast<std::size_t>(std::ceil(per_omega * cutoff)) + 2;
  for (const auto& found : modes_by_order<ToroidalEdge>({per_omega, per_omega}, cutoff, orders, poll)) {
    modes.insert(modes.end(), found.begin(), found.end());
  }
  return modes;
}

}  // namespace stoss::bodies::sphere
