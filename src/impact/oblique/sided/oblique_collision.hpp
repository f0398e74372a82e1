#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "contact/edge/edge_law.hpp"
#include "contact/sided/sided_contact.hpp"
#include "impact/contact_history.hpp"
#include "impact/ending.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/oblique/parity_block.hpp"
#include "impact/oblique/sided/rigid_motion.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/oblique.hpp"

namespace stoss {

/// The motion of two bodies that press and rub each other at points on both sides of the axis, in which each direction
/// moves the other: as rigid ones (RigidMotion), and by the modes of both parities, by kick–rotate–kick as Collision.
/// In a step the points move by what the modes above the cutoff answer; SidedContact finds the forces. Turning moves
/// points along y only (linear kinematics, docs/theory/oblique.md).
class ObliqueCollision {
 public:
  /// Starts as Collision, with nothing stuck.
  /// @param along the contact against forces along the surface, of both parities (contacts_along)
  ObliqueCollision(const Contact& contact, const std::vector<Contact>& along, const FixedResolution& resolution,
                   const ContactGrid& grid, const ObliqueFrame& frame, const Obliquity& obliquity,
                   const std::optional<State>& start, const Poll& poll);

  /// Moves on by one step.
  void advance();

  /// The contact has reached the end of the grid, so that the result is void.
  [[nodiscard]] bool overflows() const { return nodes_.extent() == points_.count; }

  /// The motion along the normal at present.
  [[nodiscard]] Slowing slowing() const { return {history_.time(), rigid_.velocity(), 1.0, history_.in_contact()}; }

  /// They recede and can touch no more.
  [[nodiscard]] bool over();

  /// Distance at which bodies that vibrate freely, as at present, do not touch.
  [[nodiscard]] double clearance() const { return reach() + std::max(range_, 0.0); }

  /// Distance of the foremost points, below 0 where they do not reach each other.
  [[nodiscard]] double compression() const { return rigid_.compression(); }

  /// Steps in which bodies that vibrate, and part so slowly that they are not clear of each other, will have done so.
  [[nodiscard]] double steps_to_leave() const;

  /// Shows the instant.
  void show(const ObliqueImpactObserver& observer);

  /// The impact so far; body, wall and resolution are left to the caller. @param rest of a body that may stay
  [[nodiscard]] ObliqueImpact result(const Rest& rest) const;

 private:
  void respond();
  void answer();
  void record();
  [[nodiscard]] bool parts() const;
  [[nodiscard]] double reach() const;
  [[nodiscard]] double normal_motion() const { return 0.5 * contact_.mass * rigid_.velocity() * rigid_.velocity(); }
  [[nodiscard]] double dissipated(int body) const;
  [[nodiscard]] double stored() const { return even_.residuals.stored() + odd_.residuals.stored(); }
  [[nodiscard]] AlongOutcome outcome() const;
  void show_ledger(ObliqueImpact& impact) const;

  const Contact& contact_;
  Obliquity obliquity_;
  ObliqueFrame frame_;
  double step_;
  ContactPoints points_;
  ParityBlock even_, odd_;  // of normal forces that are even in y, and of friction that is
  EdgeLaw law_;             // of the points of one side
  SidedContact nodes_;
  RigidMotion rigid_;
  ContactHistory history_;
  Eigen::VectorXd recess_;  // of the points on both sides
  double range_, touch_;
  bool lossy_;
  double first_share_;  // of the first body in what the edge law takes

  bool begun_ = false;
  Eigen::VectorXd x_, y_;                 // where the modes put the points
  Eigen::VectorXd moved_x_, moved_y_;     // by the modes above the cutoff, into the body and against y
  Eigen::VectorXd place_, place_before_;  // of the points along y; in the step before
  Eigen::VectorXd force_, rub_;           // f and q
  double foremost_ = 0.0, foremost_before_ = 0.0;

  std::vector<double> energy_before_;  // of each even mode, if any moves
  double work_ = 0.0, edge_work_ = 0.0, heat_ = 0.0;
  double reach_ = -1.0;  // of the free vibration; < 0: not known
  std::vector<ObliquePoint> seen_;
};

}  // namespace stoss
