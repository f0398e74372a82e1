#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "contact/edge/compliance.hpp"
#include "contact/edge/edge_law.hpp"
#include "contact/friction.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// The compliance between points on both sides of the axis, first all on the right, then their mirror images: of the
/// displacement x against the normal force f of each, and of y against its friction q,
///
///   u_x = xx f + xy q,   u_y = xyᵀ f + yy q.
struct CoupledCompliance {
  Eigen::MatrixXd xx, xy, yy;
};

/// @param normal_even, along_even the blocks of bodies with two components (Body::along), 2 · points × 2 · points
[[nodiscard]] CoupledCompliance compliance_of_sides(const std::vector<double>& normal_even,
                                                    const std::vector<double>& along_even, std::size_t points);

/// Anderson's acceleration of a fixed-point iteration x ← x + miss(x): the next trial is the combination of the last
/// ones whose misses, taken for linear, are least (Anderson, J. ACM 12, 547, 1965).
class Anderson {
 public:
  explicit Anderson(std::size_t memory) : memory_(memory) {}

  /// Forgets what was tried, as when the function changes.
  void forget();

  /// @param share of the miss by which it moves while little is known
  [[nodiscard]] Eigen::VectorXd next(const Eigen::VectorXd& tried, const Eigen::VectorXd& miss, double share = 1.0);

 private:
  std::size_t memory_;
  std::vector<Eigen::VectorXd> tried_, misses_;
};

/// The contact problem of a step for surfaces in which normal force and friction each move the other's direction, with
/// points on both sides of the axis, or rings around it: forces f ≥ 0 and friction q such that
///
///   g = xx f + xy q − x                              obey the edge law with f,
///   r = y − yy q − xyᵀ f − D (q − q_before)          Coulomb's law with |q| ≤ μ f (Friction).
///
/// One is solved after the other till nothing changes. The friction of sliding nodes, ±μ f, is taken into the matrix of
/// the normal problem: Newton's method for it exists at any μ while all slide to one side, and the iteration is over at
/// once. What the stuck nodes carry is accelerated (Anderson); where that leads nowhere, other ways are tried. Where μ
/// times the coupling exceeds about 1 there may be no solution, or more than one: Coulomb's law is then ill-posed.
class CoupledContact {
 public:
  /// @param compliance of points on both sides, or of rings: of as many as the law has
  /// @param law   of the points of one side, of a force that both sides share
  /// @param ratio local softness along the surface over that along the normal
  CoupledContact(CoupledCompliance compliance, const EdgeLaw& law, double friction, double ratio, Poll poll);

  /// Solves one step, from the last one.
  /// @param x positions beyond the plane of contact without the forces of this step
  /// @param y slips without its friction
  /// @throws NotConverged if no forces are found that obey both laws
  void solve(const Eigen::VectorXd& x, const Eigen::VectorXd& y);

  /// Tells the law of a lossy contact how the foremost points have moved in a step, before it is solved.
  void follow(double before, double now, double step);

  [[nodiscard]] const Eigen::VectorXd& force() const { return force_; }
  [[nodiscard]] const Eigen::VectorXd& friction() const { return friction_; }
  [[nodiscard]] const Eigen::VectorXd& gap() const { return gap_; }

  /// Of the last solution, as Friction has it; means nothing where nothing touches.
  [[nodiscard]] const std::vector<int>& sliding() const { return coulomb_.sliding(); }

  /// Number of leading points of a side beyond which the last forces of both vanish.
  [[nodiscard]] std::size_t extent() const;

  /// Whether the contact reaches the last points, as EdgeContact has it.
  [[nodiscard]] bool overflows() const;

  /// Half-width of the last contact in spacings, the mean of both sides.
  [[nodiscard]] double half_width() const;

  /// Displacements that the last forces make.
  [[nodiscard]] Eigen::VectorXd moved_x() const { return compliance_.xx * force_ + compliance_.xy * friction_; }
  [[nodiscard]] Eigen::VectorXd moved_y() const {
    return compliance_.xy.transpose() * force_ + compliance_.yy * friction_;
  }

 private:
  /// A way to find the forces of a step.
  struct Attempt {
    bool with_force;     // the friction of sliding nodes moves with their force, else all of it is held
    bool all_slide;      // at first, each as it would slip; else those that slid in the step before
    bool accelerated;    // what is held
    double share = 1.0;  // of what is missed by which it moves, while that is not accelerated
    int most = 120;      // rounds
  };
  [[nodiscard]] bool solved(const Attempt& attempt, const Eigen::VectorXd& x, const Eigen::VectorXd& y);
  void take_into_matrix(const std::vector<int>& sliding);
  [[nodiscard]] bool solve_normal(const Eigen::VectorXd& x, double scale);
  void solve_friction(const Eigen::VectorXd& x, const Eigen::VectorXd& y);
  [[nodiscard]] double reached(const Eigen::VectorXd& x) const;

  CoupledCompliance compliance_;
  std::vector<double> along_;  // yy, by rows
  std::size_t sides_;
  EdgeLaw law_;
  double coefficient_, ratio_;
  Poll poll_;
  Friction coulomb_;
  Anderson anderson_;
  Eigen::VectorXd force_, friction_, gap_;  // of the last step
  std::vector<double> closure_;
  VaryingCompliance matrix_;                            // of the normal problem
  std::vector<int> in_matrix_;                          // states of the nodes whose friction it has
  Eigen::VectorXd held_, used_;                         // friction that is tried: of stuck nodes; of all
  Eigen::VectorXd new_force_, new_friction_, new_gap_;  // of this step
  std::vector<double> new_closure_, give_, free_, limit_, q_;
};

}  // namespace stoss
