// gap(r) = r²/2 − δ + u(r), u = Σ_j U_j(r) p(gap_j), F = Σ p_j A_j: the equilibria of a paraboloid that attracts an
// elastic half-space. They are one curve with up to two folds of δ, along which the gap at the axis falls throughout.
#include "half_space.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

namespace adhesion_study {
namespace {

using std::numbers::pi;

/// Displacement at r under unit pressure on a disk of radius b, E* = 1 (K. L. Johnson, Contact Mechanics, 1985, §3.4).
double under_disk(double r, double b) {
  if (b <= 0.0) return 0.0;
  if (r < b) return 4.0 * b / pi * std::comp_ellint_2(r / b);
  const double k = b / r;
  return 4.0 * r / pi * (std::comp_ellint_2(k) - (1.0 - k * k) * std::comp_ellint_1(k));
}

/// A quantity of the curve where its approach is that of a fold: parabolas through three points.
struct Fold {
  double approach = 0.0, energy = 0.0;
  bool found = false;
};

/// Values at x of the parabola through three points.
double parabola(const std::array<double, 3>& x, const std::array<double, 3>& y, double at) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    double weight = y[i];
    for (std::size_t j = 0; j < 3; ++j)
      if (j != i) weight *= (at - x[j]) / (x[i] - x[j]);
    sum += weight;
  }
  return sum;
}

/// Where the parabola through three points has its extremum.
double extremum(const std::array<double, 3>& x, const std::array<double, 3>& y) {
  const double a = (y[1] - y[0]) / (x[1] - x[0]), b = (y[2] - y[1]) / (x[2] - x[1]);
  const double curvature = (b - a) / (x[2] - x[0]);
  return 0.5 * (x[0] + x[1]) - 0.5 * a / curvature;
}

std::array<double, 3> around(const std::vector<Equilibrium>& curve, std::size_t i, double Equilibrium::*member) {
  return {curve[i - 1].*member, curve[i].*member, curve[i + 1].*member};
}

/// The first fold from a place on, at which the approach has a maximum (sign 1) or a minimum (sign −1).
Fold fold(const std::vector<Equilibrium>& curve, std::size_t& from, double sign) {
  for (std::size_t i = std::max<std::size_t>(from, 1); i + 1 < curve.size(); ++i) {
    if (sign * (curve[i].approach - curve[i - 1].approach) < 0.0) continue;
    if (sign * (curve[i + 1].approach - curve[i].approach) >= 0.0) continue;
    const auto x = around(curve, i, &Equilibrium::innermost);
    const auto approach = around(curve, i, &Equilibrium::approach), energy = around(curve, i, &Equilibrium::energy);
    const double at = extremum(x, approach);
    from = i;
    return {parabola(x, approach, at), parabola(x, energy, at), true};
  }
  return {};
}

/// Energy at an approach on the part of the curve between two places, by the cubic that has both forces.
double energy_at(const std::vector<Equilibrium>& curve, std::size_t begin, std::size_t end, double approach) {
  for (std::size_t i = begin; i + 1 < end; ++i) {
    const Equilibrium &left = curve[i], &right = curve[i + 1];
    const double length = right.approach - left.approach, s = (approach - left.approach) / length;
    if (s < 0.0 || s > 1.0) continue;
    return left.energy * (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s) + right.energy * (3.0 - 2.0 * s) * s * s +
           length * s * (1.0 - s) * (left.force * (1.0 - s) - right.force * s);
  }
  throw std::runtime_error("the curve ends before the other side of a jump");
}

Static statics(const Law& law, double range, double tabor, int rings, double cut) {
  // Contacts grow beyond that of no load, a³ = 9π/2, up to the other side of the jump into contact.
  const double last = 0.5 + 0.5 / tabor, widest = std::cbrt(4.5 * pi) + 0.3;
  const double radius = std::max(std::sqrt(2.0 * (cut * range + 2.0)), std::sqrt(widest * widest + cut * range));
  return read(curve(Rings(law, radius, rings), std::max(cut * range, 3.0), last, 0.05));
}

}  // namespace

Rings::Rings(Law law, double radius, int count)
    : law_(std::move(law)), radius_(count), area_(count), compliance_(count, count) {
  const double width = radius / count;
  for (int j = 0; j < count; ++j) {
    radius_[j] = (j + 0.5) * width;
    area_[j] = 2.0 * pi * radius_[j] * width;
  }
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < count; ++i)
      compliance_(i, j) = under_disk(radius_[i], (j + 1) * width) - under_disk(radius_[i], j * width);
}

double Rings::force(const Eigen::VectorXd& gap) const {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < count(); ++i) sum += area_[i] * law_(gap[i]).pressure;
  return sum + 2.0 * pi * law_(gap[count() - 1] + 0.25 * (gap[count() - 1] - gap[count() - 2])).energy;
}

double Rings::energy(const Eigen::VectorXd& gap) const {
  Eigen::VectorXd pressure(count());
  double sum = 0.0;
  for (Eigen::Index i = 0; i < count(); ++i) {
    const Response response = law_(gap[i]);
    pressure[i] = response.pressure;
    sum += area_[i] * response.energy;
  }
  return sum + 0.5 * area_.cwiseProduct(pressure).dot(compliance_ * pressure);
}

bool Rings::solve(double innermost, Eigen::VectorXd& gap, double& approach) const {
  const Eigen::Index n = count();
  const double first = 0.5 * radius_[0] * radius_[0];
  Eigen::VectorXd pressure(n), slope(n);
  gap[0] = innermost;
  for (int iteration = 0; iteration < 30; ++iteration) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const Response response = law_(gap[i]);
      pressure[i] = response.pressure;
      slope[i] = response.slope;
    }
    const Eigen::VectorXd displacement = compliance_ * pressure;
    // The first ring gives the approach; the others have their equations.
    approach = first + displacement[0] - gap[0];
    const Eigen::VectorXd rest =
        gap - 0.5 * radius_.cwiseAbs2() - displacement + Eigen::VectorXd::Constant(n, approach);
    Eigen::MatrixXd tangent = -compliance_ * slope.asDiagonal();
    tangent.rowwise() -= tangent.row(0).eval();
    tangent.diagonal().array() += 1.0;
    const Eigen::VectorXd change = tangent.bottomRightCorner(n - 1, n - 1).partialPivLu().solve(rest.tail(n - 1));
    if (!change.allFinite()) return false;
    const double largest = change.cwiseAbs().maxCoeff();
    gap.tail(n - 1) -= change * std::min(1.0, 2.0 / largest);
    if (largest < 1e-12 * (10.0 + gap[n - 1])) {
      for (Eigen::Index i = 0; i < n; ++i) pressure[i] = law_(gap[i]).pressure;
      approach = first + (compliance_ * pressure)[0] - gap[0];
      return true;
    }
  }
  return false;
}

std::vector<Equilibrium> curve(const Rings& rings, double start, double last_approach, double step) {
  std::vector<Equilibrium> result;
  Eigen::VectorXd gap = rings.undeformed(start), before = gap;
  double approach = -start, parameter = start, change = 0.2 * start, last_change = change;
  const auto keep = [&] { result.push_back({parameter, approach, rings.force(gap), rings.energy(gap)}); };
  if (!rings.solve(start, gap, approach)) throw std::runtime_error("no equilibrium far away");
  before = gap;
  keep();
  while (approach < last_approach || result.size() < 3) {
    Eigen::VectorXd next = result.size() > 1 ? Eigen::VectorXd(gap + (gap - before) * (change / last_change)) : gap;
    double at = approach;
    const bool found = rings.solve(parameter - change, next, at);
    const double moved = found ? (next - gap).cwiseAbs().maxCoeff() : 0.0;
    if (!found || (moved > 4.0 * step && std::abs(at - approach) > 0.1 * step)) {
      change *= 0.5;
      if (change < 1e-9 * start) throw std::runtime_error("the curve of equilibria cannot be followed");
      continue;
    }
    before = gap;
    gap = next;
    approach = at;
    parameter -= change;
    last_change = change;
    keep();
    change *= std::clamp(2.0 * step / moved, 0.5, 1.5);
  }
  return result;
}

Static read(const std::vector<Equilibrium>& curve) {
  Static result{};
  for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
    if (curve[i].force > curve[i - 1].force || curve[i].force > curve[i + 1].force) continue;
    const auto x = around(curve, i, &Equilibrium::innermost), force = around(curve, i, &Equilibrium::force);
    result.pull_off = std::max(result.pull_off, -parabola(x, force, extremum(x, force)));
  }
  std::size_t in = 1, out = 1;
  const Fold jump_in = fold(curve, in, 1.0);
  if (!jump_in.found) return result;
  out = in + 1;
  const Fold jump_out = fold(curve, out, -1.0);
  if (!jump_out.found) throw std::runtime_error("the curve ends before it folds back");
  result.jump_in = jump_in.approach;
  result.jump_out = jump_out.approach;
  result.work = jump_in.energy - energy_at(curve, out, curve.size(), jump_in.approach) + jump_out.energy -
                energy_at(curve, 0, in + 1, jump_out.approach);
  return result;
}

Static exponential_statics(double tabor, int rings, double ratio) {
  const double range = range_of(tabor, 1.0, 1.0, ratio);
  return statics(exponential_law(1.0, range, ratio), range, tabor, rings, 16.0);
}

Static lennard_jones_statics(double tabor, int rings) {
  const double distance = 1.0 / tabor;
  return statics(lennard_jones(1.0, distance), distance, tabor, rings, 30.0);
}

}  // namespace adhesion_study
