#include "contact/edge/edge_newton.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stoss {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rounding = 1e-14;

using Vector = std::array<double, 3>;

/// Solves a x = b by Cramer's rule. @return whether the determinant is positive
bool solve_three(const std::array<Vector, 3>& a, const Vector& b, Vector& x) {
  const double c00 = a[1][1] * a[2][2] - a[1][2] * a[2][1];
  const double c10 = a[1][2] * a[2][0] - a[1][0] * a[2][2];
  const double c20 = a[1][0] * a[2][1] - a[1][1] * a[2][0];
  const double determinant = a[0][0] * c00 + a[0][1] * c10 + a[0][2] * c20;
  if (!(determinant > 0.0)) return false;
  const double share = 1.0 / determinant;
  x[0] = share *
         (c00 * b[0] + (a[0][2] * a[2][1] - a[0][1] * a[2][2]) * b[1] + (a[0][1] * a[1][2] - a[0][2] * a[1][1]) * b[2]);
  x[1] = share *
         (c10 * b[0] + (a[0][0] * a[2][2] - a[0][2] * a[2][0]) * b[1] + (a[0][2] * a[1][0] - a[0][0] * a[1][2]) * b[2]);
  x[2] = share *
         (c20 * b[0] + (a[0][1] * a[2][0] - a[0][0] * a[2][1]) * b[1] + (a[0][0] * a[1][1] - a[0][1] * a[1][0]) * b[2]);
  return true;
}

// What Newton's method asks of a compliance that is symmetric and factored, or neither.

auto entries(const FactoredCompliance& compliance) { return compliance.matrix(); }
const MatrixXd& entries(const VaryingCompliance& compliance) { return compliance.matrix(); }

void multiply(const FactoredCompliance& compliance, const std::vector<double>& force, std::vector<double>& result) {
  compliance.multiply(0, force.size(), force, result);
}

void multiply(const VaryingCompliance& compliance, const std::vector<double>& force, std::vector<double>& result) {
  const MatrixXd& w = compliance.matrix();
  VectorXd::Map(result.data(), w.rows()).setZero();
  for (std::size_t j = 0; j < force.size(); ++j) {
    if (force[j] == 0.0) continue;
    VectorXd::Map(result.data(), w.rows()) += w.col(static_cast<Index>(j)) * force[j];
  }
}

/// Solves for the block of some nodes and a diagonal, in place. @return whether that is regular
bool solve(const FactoredCompliance& compliance, const std::vector<Index>& nodes, const VectorXd& diagonal,
           VectorXd& x) {
  const auto w = compliance.matrix();
  const auto m = static_cast<Index>(nodes.size());
  MatrixXd block(m, m);
  if (nodes.back() + 1 == m) {
    block = w.transpose().topLeftCorner(m, m);  // by columns: it is symmetric
  } else {
    for (Index b = 0; b < m; ++b) {
      for (Index a = b; a < m; ++a)
        block(a, b) = w(nodes[static_cast<std::size_t>(a)], nodes[static_cast<std::size_t>(b)]);
    }
  }
  block.diagonal() += diagonal;
  const Eigen::LLT<Eigen::Ref<MatrixXd>> factored(block);
  if (factored.info() != Eigen::Success) return false;
  factored.solveInPlace(x);
  return true;
}

bool solve(VaryingCompliance& compliance, const std::vector<Index>& nodes, const VectorXd& diagonal, VectorXd& x) {
  return compliance.solve(nodes, diagonal, x);
}

/// Residual of each node over what rounding is measured by there: far from the contact the nodes are far behind.
double norm(const VectorXd& rest, const std::vector<double>& q, double scale) {
  double sum = 0.0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const double relative = rest(static_cast<Index>(i)) / (scale + std::abs(q[i]));
    sum += relative * relative;
  }
  return std::sqrt(sum / static_cast<double>(q.size()));
}

/// W f(t) − q − g(t) on all nodes.
template <typename Compliance>
VectorXd residual(const Compliance& compliance, const EdgeLaw& law, const std::vector<double>& q,
                  const std::vector<double>& closure) {
  const std::size_t n = q.size();
  std::vector<double> force(n), result(n);
  for (std::size_t i = 0; i < n; ++i) force[i] = law.force_at(i, closure[i]);
  multiply(compliance, force, result);
  VectorXd rest(static_cast<Index>(n));
  for (std::size_t i = 0; i < n; ++i) {
    rest(static_cast<Index>(i)) = result[i] - q[i] - law.gap_at(i, closure[i]);
  }
  return rest;
}

/// The Newton step. Nodes with t ≤ 0 carry no force and follow the others, so only those in contact are coupled; with
/// their changes of force for unknowns the matrix is W and a diagonal, positive definite. Empty if it is singular.
template <typename Compliance>
std::vector<double> step(Compliance& compliance, const EdgeLaw& law, const std::vector<double>& closure,
                         const VectorXd& rest) {
  const std::size_t n = closure.size();
  const auto& w = entries(compliance);
  std::vector<Index> active;
  for (std::size_t i = 0; i < n; ++i) {
    if (closure[i] > 0.0) active.push_back(static_cast<Index>(i));
  }
  const auto m = static_cast<Index>(active.size());
  VectorXd diagonal(m), change(m);  // of the forces
  for (Index b = 0; b < m; ++b) {
    const Index j = active[static_cast<std::size_t>(b)];
    const auto node = static_cast<std::size_t>(j);
    diagonal(b) = law.gap_slope(node, closure[node]) / law.force_slope(node, closure[node]);
    change(b) = -rest(j);
  }
  if (m > 0 && !solve(compliance, active, diagonal, change)) return {};
  std::vector<double> result(n);
  for (Index a = 0; a < m; ++a) {
    const auto node = static_cast<std::size_t>(active[static_cast<std::size_t>(a)]);
    result[node] = change(a) / law.force_slope(node, closure[node]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (closure[i] > 0.0) continue;
    double left = rest(static_cast<Index>(i));
    for (Index a = 0; a < m; ++a) left += w(static_cast<Index>(i), active[static_cast<std::size_t>(a)]) * change(a);
    result[i] = -left / law.gap_slope(i, closure[i]);
  }
  return result;
}

bool is_small(const std::vector<double>& change) {
  constexpr double most = 1e-6;
  return std::all_of(change.begin(), change.end(), [](double each) { return std::abs(each) <= most; });
}

/// Newton's method with steps halved while the residual does not fall.
template <typename Compliance>
bool find_closures(Compliance& compliance, const EdgeLaw& law, const std::vector<double>& q, double scale,
                   const Poll& poll, std::vector<double>& closure) {
  constexpr int most = 200;
  const auto& w = entries(compliance);
  VectorXd rest = residual(compliance, law, q, closure);
  for (int iteration = 0; iteration < most; ++iteration) {
    if (poll) poll();
    const double size = norm(rest, q, scale);
    if (size <= rounding) return true;
    std::vector<double> change = step(compliance, law, closure, rest);
    if (change.empty()) return false;
    if (law.asperities > 0.0 && is_small(change)) {  // the next would be its square
      for (std::size_t i = 0; i < closure.size(); ++i) closure[i] += change[i];
      return true;
    }
    std::vector<double> next(closure.size());
    VectorXd left;
    const auto shortened = [&](const std::vector<double>& along) {
      constexpr int most_halvings = 40;
      double share = 1.0;
      for (int halving = 0; halving < most_halvings; ++halving) {
        for (std::size_t i = 0; i < next.size(); ++i) {
          const auto k = static_cast<Index>(i);
          next[i] = law.moved(i, closure[i], share * along[i], w(k, k));
        }
        left = residual(compliance, law, q, next);
        if (norm(left, q, scale) < size) return true;
        share *= 0.5;
      }
      return false;
    };
    if (!shortened(change)) {
      // A node that is about to carry force has hardly any slope, and its t would have to leap.
      for (std::size_t i = 0; i < next.size(); ++i) {
        const double longest = 0.5 * (1.0 + std::abs(closure[i]));
        change[i] = std::clamp(change[i], -longest, longest);
      }
      // No step helps: the residual is rounding, or the method has failed.
      if (!shortened(change)) return size <= 100.0 * rounding;
    }
    closure = next;
    rest = left;
  }
  return false;
}

}  // namespace

bool solve_zone(const EdgeLaw& law, EdgeZone& zone) {
  constexpr int most = 40;
  Vector& t = zone.closure;
  Vector full_force{}, full_gap{};
  for (std::size_t a = 0; a < zone.count; ++a) {
    full_force[a] = law.full_force(zone.first + a);
    full_gap[a] = law.full_gap(zone.first + a);
  }
  for (int iteration = 0; iteration < most; ++iteration) {
    // Positive: W is positive definite, and of each node a force or a gap rises. Nodes beyond the last stay.
    std::array<Vector, 3> jacobian{};
    Vector rest{}, force{}, slope{}, change{};
    for (std::size_t b = 0; b < 3; ++b) {
      const double closed = std::max(t[b], 0.0);
      force[b] = full_force[b] * closed * closed;
      slope[b] = 2.0 * full_force[b] * closed;
    }
    for (std::size_t a = 0; a < 3; ++a) {
      const double open = std::max(1.0 - t[a], 0.0);
      rest[a] = zone.position[a] + full_gap[a] * open * open;
      for (std::size_t b = 0; b < 3; ++b) {
        rest[a] -= zone.compliance[a][b] * force[b];
        jacobian[a][b] = zone.compliance[a][b] * slope[b];
      }
      jacobian[a][a] += a < zone.count ? 2.0 * full_gap[a] * open : 1.0;
    }
    if (!solve_three(jacobian, rest, change)) return false;
    double largest = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double longest = 0.5 * (1.0 + std::abs(t[a]));  // t grows by half of itself at most
      t[a] += std::clamp(change[a], -longest, longest);
      largest = std::max(largest, std::abs(change[a]) / (1.0 + std::abs(t[a])));
    }
    if (largest < 1e-8) return true;  // converges quadratically: what is left is rounding
  }
  return false;
}

bool solve_all(const FactoredCompliance& compliance, const EdgeLaw& law, const std::vector<double>& q, double scale,
               const Poll& poll, std::vector<double>& closure) {
  return find_closures(compliance, law, q, scale, poll, closure);
}

bool solve_all(VaryingCompliance& compliance, const EdgeLaw& law, const std::vector<double>& q, double scale,
               const Poll& poll, std::vector<double>& closure) {
  return find_closures(compliance, law, q, scale, poll, closure);
}

}  // namespace stoss
