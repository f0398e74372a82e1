#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "contact/coupled/coupled_contact.hpp"
#include "contact/edge/edge_law.hpp"
#include "contact/zener.hpp"
#include "impact/contact_history.hpp"
#include "impact/ending.hpp"
#include "impact/normal_motion.hpp"
#include "impact/oblique/coupled_modes.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/oblique/tangential_motion.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/oblique.hpp"

namespace stoss {

/// The motion of two bodies that press and rub each other, in which each direction moves the other, by
/// kick–rotate–kick as Collision: as rigid ones (NormalMotion, TangentialMotion) and by their modes (CoupledModes). In
/// a step the points move by what the modes above the cutoff answer; CoupledContact finds the forces.
///
/// y lies along the surface for points on both sides of the axis, as of disks. For rings, as of balls, it points
/// outward: friction is alike all around, and moves no body as a whole.
class CoupledCollision {
 public:
  /// Starts as Collision, with nothing stuck.
  /// @param along the contact against forces along y: both parities (contacts_along), or rings (contact_outward)
  CoupledCollision(const Contact& contact, const std::vector<Contact>& along, const FixedResolution& resolution,
                   const ContactGrid& grid, const ObliqueFrame& frame, const Obliquity& obliquity,
                   const std::optional<State>& start, const Poll& poll);

  /// Moves on by one step.
  void advance();

  /// The contact has reached the end of the grid, so that the result is void.
  [[nodiscard]] bool overflows() const { return nodes_.overflows(); }

  /// They recede and can touch no more.
  [[nodiscard]] bool over();

  /// The motion along the normal at present.
  [[nodiscard]] Slowing slowing() const { return {history_.time(), velocity(), 1.0, history_.in_contact()}; }

  [[nodiscard]] double compression() const { return center_.compression(); }
  [[nodiscard]] double velocity() const { return center_.velocity(); }

  /// Energies; of the motion along the normal.
  [[nodiscard]] double translation() const { return center_.energy(); }
  [[nodiscard]] double vibration() const { return modes_.energy(); }

  /// Distance at which bodies that vibrate freely, as at present, do not touch.
  [[nodiscard]] double clearance() const { return modes_.reach() + std::max(range_, 0.0); }

  /// At the points in the last step: f, q, how far each has slid, and how much further it gives along y.
  [[nodiscard]] const Eigen::VectorXd& force() const { return force_; }
  [[nodiscard]] const Eigen::VectorXd& friction() const { return friction_; }
  [[nodiscard]] Eigen::VectorXd slip() const { return place_ - place_before_; }
  [[nodiscard]] Eigen::VectorXd give() const;

  /// Shows the instant.
  void show(const ObliqueImpactObserver& observer);

  /// The impact so far; body, wall and resolution are left to the caller. @param rest of a body that may stay
  [[nodiscard]] ObliqueImpact result(const Rest& rest) const;

 private:
  void respond();
  void solve();
  void record();
  [[nodiscard]] double whole_velocity() const;
  [[nodiscard]] double dissipated(int body) const;
  [[nodiscard]] AlongOutcome outcome() const;
  [[nodiscard]] double rigid_energy() const;
  void show_ledger(ObliqueImpact& impact) const;

  const Contact& contact_;
  Obliquity obliquity_;
  ObliqueFrame frame_;
  double step_;
  ContactPoints points_;
  CoupledModes modes_;
  EdgeLaw law_;  // of the points of one side
  CoupledContact nodes_;
  NormalMotion center_;
  std::optional<TangentialMotion> along_;  // empty: rings
  ContactHistory history_;
  Eigen::VectorXd recess_;
  double range_, touch_, threshold_;
  bool lossy_;
  double first_share_;  // of the first body in what the edge law takes
  double start_compression_, start_energy_ = 0.0;

  bool begun_ = false;
  Eigen::VectorXd x_, y_;                 // where the modes put the points
  Eigen::VectorXd moved_x_, moved_y_;     // by the modes above the cutoff, into the body and against y
  Eigen::VectorXd place_, place_before_;  // of the points along y; in the step before
  Eigen::VectorXd force_, friction_;      // f and q
  Eigen::VectorXd force_before_, gap_before_;
  double foremost_ = 0.0, foremost_before_ = 0.0;

  std::vector<double> energy_before_;  // of each mode, if any moves
  double work_ = 0.0, edge_work_ = 0.0, heat_ = 0.0;
  double reach_ = -1.0;  // of the free vibration; < 0: not known
  std::vector<ObliquePoint> seen_;
};

}  // namespace stoss
