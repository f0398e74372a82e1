// The modes answer node forces g with Q = −(1/mω²) Σ_i g_i (C c_i + S s_i), so that the energy is a function of g
// alone:
//
//   U(g) = ½ gᵀWg + V(x),   x = q − Wg,   W = (1/m) Σ_kept (C c + S s)(C c + S s)ᵀ/ω²,   V = Σ_i μ_i e^{αx_i}.
//
// With f = ∂V/∂x and D = diag(αf) a Newton step solves (W + WDW) s = W(f − g). W is singular where there are more nodes
// than modes can move; s = f − g − √D z with (1 + √D W √D) z = √D W (f − g) is the same and needs no inverse of W.
#include "stoss/quasistatic/soft_static_contact.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "check.hpp"
#include "numeric/dense.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss::quasistatic {
namespace {

namespace dense = numeric::dense;

using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr long fewest_nodes = 64;
constexpr long most_nodes = 2048;

/// Static compliance of the kept modes between the nodes.
MatrixXd kept_compliance(const Contact& contact, const ContactGrid& grid, const Poll& poll) {
  const auto nodes = static_cast<Eigen::Index>(grid.recess.size());
  const auto rows = static_cast<Eigen::Index>(grid.shape.size()) / nodes;
  const Eigen::Map<const RowMajor> shape(grid.shape.data(), rows, nodes);
  // Each order as two columns whose products with themselves it contributes: the Cholesky factor of its 2 × 2 block.
  MatrixXd columns(nodes, 2 * static_cast<Eigen::Index>(contact.groups.size()));
  Eigen::Index k = 0;
  for (const ModeGroup& group : contact.groups) {
    double upper = 0.0, mixed = 0.0, lower = 0.0;
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const double weight = 1.0 / (contact.mass * group.omega[l] * group.omega[l]);
      upper += weight * group.upper[l] * group.upper[l];
      mixed += weight * group.upper[l] * group.lower[l];
      lower += weight * group.lower[l] * group.lower[l];
    }
    const VectorXd upper_row = shape.row(static_cast<Eigen::Index>(group.upper_row)).transpose();
    const VectorXd lower_row = shape.row(static_cast<Eigen::Index>(group.lower_row)).transpose();
    const double root = std::sqrt(upper);
    const double slope = root > 0.0 ? mixed / root : 0.0;
    columns.col(k++) = root * upper_row + slope * lower_row;
    columns.col(k++) = std::sqrt(std::max(0.0, lower - slope * slope)) * lower_row;
  }
  MatrixXd compliance(nodes, nodes);
  dense::by_columns(nodes, poll, [&](Eigen::Index first, Eigen::Index count) {
    compliance.middleCols(first, count).noalias() = columns * columns.middleRows(first, count).transpose();
  });
  return compliance;
}

/// Held at rest at a wall V = Σ_i μ_i (p/α) e^{α(x_i − x_p)}, whose pressure at x_p is p.
class Equilibrium {
 public:
  Equilibrium(MatrixXd compliance, VectorXd free_position, const std::vector<double>& measure, double pressure,
              double place, const Poll& poll)
      : compliance_(std::move(compliance)),
        position_(std::move(free_position)),
        load_(Eigen::Map<const VectorXd>(measure.data(), position_.size()) * pressure),
        place_(place),
        poll_(poll),
        force_(VectorXd::Zero(position_.size())),
        displacement_(VectorXd::Zero(position_.size())) {}

  /// Newton's method from the forces of the last hardness. @return number of steps
  int solve(double hardness, double tolerance) {
    constexpr int most_steps = 200;
    for (int step = 0; step < most_steps; ++step) {
      const VectorXd wall = wall_force(hardness, displacement_);
      const VectorXd excess = wall - force_;
      if (excess.lpNorm<1>() <= tolerance * wall.sum()) return step;
      const VectorXd root = (hardness * wall).cwiseSqrt();
      MatrixXd matrix = root.asDiagonal() * compliance_ * root.asDiagonal();
      matrix.diagonal().array() += 1.0;
      const VectorXd pull = compliance_ * excess;
      if (!dense::factor(matrix, poll_)) break;
      MatrixXd right = root.cwiseProduct(pull);
      dense::solve(matrix, right, poll_);
      const VectorXd direction = excess - root.cwiseProduct(right.col(0));
      if (!line_search(hardness, direction, -direction.dot(pull))) break;
    }
    throw NotConverged("soft static contact: Newton's method found no minimum of the energy (use another hardness)");
  }

  [[nodiscard]] double force() const { return force_.sum(); }
  [[nodiscard]] double elastic_energy() const { return 0.5 * force_.dot(displacement_); }
  [[nodiscard]] double wall_energy(double hardness) const {
    return wall_force(hardness, displacement_).sum() / hardness;
  }

 private:
  [[nodiscard]] VectorXd wall_force(double hardness, const VectorXd& displacement) const {
    return load_.array() * (hardness * (position_ - displacement).array() - hardness * place_).exp();
  }

  /// Halves the step until the energy falls as its slope promises; below rounding it takes the whole step.
  bool line_search(double hardness, const VectorXd& direction, double slope) {
    constexpr double share = 1e-4;
    constexpr double rounding = 1e-13;
    const VectorXd moved = compliance_ * direction;
    const double linear = force_.dot(moved), quadratic = 0.5 * direction.dot(moved);
    const double wall = wall_energy(hardness);
    const double energy = elastic_energy() + wall;
    constexpr int most_halvings = 40;
    double t = 1.0;
    for (int halving = 0; halving < most_halvings; ++halving) {
      const double pushed = wall_force(hardness, displacement_ + t * moved).sum() / hardness;
      const double change = t * (linear + t * quadratic) + (pushed - wall);
      if (std::isfinite(change) && (change <= share * t * slope || -slope <= rounding * energy)) {
        force_ += t * direction;
        displacement_ += t * moved;
        return true;
      }
      t *= 0.5;
    }
    return false;
  }

  MatrixXd compliance_;
  VectorXd position_;  // of the nodes of the undeformed body
  VectorXd load_;
  double place_;
  const Poll& poll_;
  VectorXd force_;         // g
  VectorXd displacement_;  // W g
};

/// Half-width beyond which the wall's pressure vanishes.
double pressed_half_width(const Contact& contact, double hardness, double compression) {
  constexpr double exponent = 40.0;
  const double wanted = std::sqrt(2.0 * (std::max(compression, 0.0) + exponent / hardness));
  return std::min(wanted, greatest_half_width(contact));
}

/// The midpoint rule converges exponentially once the nodes resolve the pressure: the smoother of the width 1/√α, over
/// which the undeformed gap changes the potential, and the waves of the highest order (measured: to 1e-11 in F).
int recommended_nodes(const Contact& contact, double hardness, double half_width) {
  if (has_single_point(contact)) return 1;
  const double for_modes = 128.0 + 4.0 * half_width * highest_wave_number(contact);
  const double for_wall = 3.0 * half_width * std::sqrt(hardness);
  constexpr double enough = 1024.0;
  return static_cast<int>(std::min(std::max(128.0, std::min(for_modes, for_wall)), enough));
}

}  // namespace

SoftStaticContact soft_static_contact(const Body& body, const ExponentialWall& wall, double compression,
                                      const SoftStaticContactOptions& options) {
  const Contact contact = stoss::contact(body, wall);
  require("compression", compression, {-0.5, 0.5, true, true, "-0.5 to 0.5"},
          "in R beyond the plane where V0 exp(alpha x) is 1");
  if (options.nodes) {
    require("nodes", static_cast<long>(*options.nodes), fewest_nodes, most_nodes, "of the contact grid");
  }
  const double alpha = wall.hardness;
  const double half_width = pressed_half_width(contact, alpha, compression);
  const int nodes = options.nodes ? *options.nodes : recommended_nodes(contact, alpha, half_width);
  const ContactGrid grid = contact_grid(contact, half_width, nodes);
  const VectorXd position =
      compression -
      Eigen::Map<const VectorXd>(grid.recess.data(), static_cast<Eigen::Index>(grid.recess.size())).array();

  // Softer walls that have the same place for a pressure of this size lead to the wall in question.
  const double pressure = 0.3 * std::sqrt(std::max(compression, 1.0 / alpha));
  const double place = std::log(pressure / alpha) / alpha;
  Equilibrium equilibrium(kept_compliance(contact, grid, options.poll), position, grid.measure, pressure, place,
                          options.poll);
  SoftStaticContact result;
  constexpr double loose = 1e-2;
  double softer = 8.0 / std::max(compression - place, 1e-3);
  while (softer < alpha) {
    result.newton_steps += equilibrium.solve(softer, loose);
    softer *= 2.0;
  }
  const double tolerance = 1e-12 + 8.0 * std::numeric_limits<double>::epsilon() * alpha;
  result.newton_steps += equilibrium.solve(alpha, tolerance);
  result.body = body.name;
  result.wall = wall;
  result.compression = compression;
  result.force = equilibrium.force() / body.mass;
  result.wall_energy = equilibrium.wall_energy(alpha) / body.mass;
  result.energy = equilibrium.elastic_energy() / body.mass + result.wall_energy;
  result.modes = static_cast<int>(mode_count(body));
  result.nodes = nodes;
  return result;
}

}  // namespace stoss::quasistatic
