#include "bodies/disk/parity/bodies_along.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "bodies/disk/edge_points.hpp"
#include "bodies/mode_search.hpp"
#include "bodies/residual.hpp"
#include "numeric/bessel.hpp"

namespace stoss::bodies::disk {
namespace {

/// The vibrations of a free disk with u_r = 0 and u_φ = J₁(kr)/J₁(k) at all angles, scaled as bodies::Mode: modal mass
/// that of the disk, amplitude 1 at the edge. They are free of stress there where J₂(k) = 0, and ω = k c_S.
class Torsion {
 public:
  /// Those up to a cutoff.
  Torsion(double poisson, double cutoff);

  [[nodiscard]] const std::vector<double>& omega() const { return omega_; }

  /// Σ 1/ω² over those beyond the cutoff: over all of them it is the static flexibility (1 + ν)/6, without the rotation
  /// of the disk.
  [[nodiscard]] double missing_compliance() const { return missing_compliance_; }

  /// Σ 1/ω⁴ over the same; over all of them (1 + ν)²/144.
  [[nodiscard]] double missing_second_moment() const { return missing_second_moment_; }

 private:
  std::vector<double> omega_;
  double missing_compliance_, missing_second_moment_;
};

Torsion::Torsion(double poisson, double cutoff)
    : missing_compliance_((1.0 + poisson) / 6.0), missing_second_moment_((1.0 + poisson) * (1.0 + poisson) / 144.0) {
  const double per_omega = std::sqrt(2.0 * (1.0 + poisson));
  std::vector<numeric::BesselPair> pairs(3);
  const auto second_order = [&](double k) {
    numeric::bessel_pairs(k, pairs);
    return std::ldexp(pairs[2].value, pairs[2].exponent);
  };
  for (const double k : breathing_roots(second_order, per_omega, cutoff)) {
    const double omega = k / per_omega, compliance = 1.0 / (omega * omega);
    omega_.push_back(omega);
    missing_compliance_ -= compliance;
    missing_second_moment_ -= compliance * compliance;
  }
}

std::size_t plus(std::size_t m) { return 2 * m; }
std::size_t minus(std::size_t m) { return 2 * m + 1; }

/// Adds a value of the first component at every point, then of the second.
template <typename First, typename Second>
void append(std::size_t points, std::vector<double>& values, const First& first, const Second& second) {
  for (std::size_t i = 0; i < points; ++i) values.push_back(first(i));
  for (std::size_t i = 0; i < points; ++i) values.push_back(second(i));
}

/// A plane wave that leaves a point takes along x or y what it has of normal and of shear motion: the two directions
/// by themselves, as what the one moves in the other is of second order in φ.
Surface surface_along(double poisson, Parity parity, std::size_t orders, const ContactPoints& points) {
  const double pressure = 1.0 / std::sqrt(1.0 - poisson * poisson), shear = 1.0 / std::sqrt(2.0 * (1.0 + poisson));
  const std::size_t count = points.count;
  const auto phi = [&](std::size_t i) { return edge_angle(points, i); };
  const auto length = [&](std::size_t i) { return 2.0 * points.spacing * edge_stretch(points, i); };
  const auto recess = [&](std::size_t i) { return 2.0 * std::sin(0.5 * phi(i)) * std::sin(0.5 * phi(i)); };
  const auto impedance = [&](std::size_t i, double normal, double along) {
    const double cosine = std::cos(phi(i)), sine = std::sin(phi(i));
    return length(i) / (cosine * cosine / normal + sine * sine / along);
  };
  const auto of_x = [&](std::size_t i) { return impedance(i, pressure, shear); };
  const auto of_y = [&](std::size_t i) { return impedance(i, shear, pressure); };
  Surface surface;
  append(count, surface.recess, recess, recess);
  append(count, surface.measure, length, length);
  if (parity == Parity::normal_even) {
    append(count, surface.impedance, of_x, of_y);
  } else {
    append(count, surface.impedance, of_y, of_x);
  }
  for (std::size_t m = 0; m < orders; ++m) {
    const auto angle = [&](std::size_t i) { return static_cast<double>(m) * phi(i); };
    for (const double sign : {1.0, -1.0}) {
      append(
          count, surface.shape, [&](std::size_t i) { return std::cos(angle(i)); },
          [&](std::size_t i) { return sign * std::sin(angle(i)); });
    }
  }
  return surface;
}

std::vector<ModeGroup> groups_along(const std::vector<Mode>& modes, const Torsion& torsion, Parity parity) {
  std::vector<ModeGroup> groups;
  const bool even = parity == Parity::normal_even;
  if (!even && !torsion.omega().empty()) {
    const std::size_t many = torsion.omega().size();
    groups.push_back({0,
                      torsion.omega(),
                      std::vector<double>(many, -1.0),
                      std::vector<double>(many, 0.0),
                      minus(1),
                      minus(1),
                      {},
                      0.0});
  }
  for (const Mode& mode : modes) {
    if (!even && mode.order == 0) continue;  // its brother is at rest
    const auto n = static_cast<std::size_t>(mode.order);
    if (groups.empty() || groups.back().order != mode.order) {
      ModeGroup group{mode.order, {}, {}, {}, plus(n + 1), n > 0 ? minus(n - 1) : plus(1), {}, 1.0 * mode.order};
      if (!even) group.upper_row = minus(n + 1), group.lower_row = plus(n - 1);
      groups.push_back(std::move(group));
    }
    const double upper = 0.5 * (mode.radial + mode.tangential);
    groups.back().omega.push_back(mode.omega);
    groups.back().upper.push_back(even ? upper : -upper);
    groups.back().lower.push_back(0.5 * (mode.radial - mode.tangential));
  }
  return groups;
}

/// Static response of the modes that are not kept, torsion among them, between the displacements of a block.
class ResidualAlong {
 public:
  ResidualAlong(double poisson, double cutoff, const std::vector<Mode>& modes, Torsion torsion)
      : poisson_(poisson),
        highest_order_(static_cast<int>(std::lround(8.0 * cutoff))),
        kept_(modes),
        torsion_(std::move(torsion)) {}

  [[nodiscard]] std::vector<double> compliance(Parity parity, const ContactPoints& points, const Poll& poll) const {
    OrderSum sum{poisson_, true, kept_.missing_compliance()};
    if (sum.coefficients.empty()) sum.coefficients.emplace_back();
    sum.coefficients.front().tangential += torsion_.missing_compliance();
    return sum_over_orders(sum, parity, points, poll);
  }

  [[nodiscard]] std::vector<double> second_moment(Parity parity, const ContactPoints& points, const Poll& poll) const {
    const auto whole = [this](int n) { return static_second_moment(poisson_, n); };
    OrderSum sum{poisson_, false, kept_.remaining_second_moment(highest_order_, whole)};
    sum.coefficients.front().tangential += torsion_.missing_second_moment();
    return sum_over_orders(sum, parity, points, poll);
  }

 private:
  double poisson_;
  int highest_order_;  // in the second moment
  KeptSums kept_;
  Torsion torsion_;
};

}  // namespace

std::vector<Body> bodies_along(const Body& disk, double poisson, const std::shared_ptr<const std::vector<Mode>>& modes,
                               const Poll& poll) {
  if (poll) poll();
  const Torsion torsion(poisson, kept_cutoff(disk));
  const auto residual = std::make_shared<const ResidualAlong>(poisson, disk.cutoff, *modes, torsion);
  const std::size_t orders = modes->empty() ? 2 : static_cast<std::size_t>(modes->back().order) + 2;
  return of_parities(
      {Parity::normal_even, Parity::along_even}, disk,
      [&](Parity parity) { return groups_along(*modes, torsion, parity); },
      [poisson, orders](Parity parity, const ContactPoints& points) {
        return surface_along(poisson, parity, orders, points);
      },
      residual);
}

}  // namespace stoss::bodies::disk
