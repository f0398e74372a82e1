#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "impact/oblique_frame.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/oblique.hpp"

namespace stoss {

/// Two bodies as rigid ones, in relative motion under the forces f_i and the friction q_i at points on both sides of
/// the axis, in units of the first:
///
///   μ Ẍ = −Σ f_i,   μ Ÿ = −Σ q_i,   I_k Θ̈_k = −Σ q_i R_k cos φ_i.
///
/// By kick, drift, kick: between two steps the velocities are those before the kick that is due, whose two halves end
/// one step and begin the next. All that is read out has half of it.
class RigidMotion {
 public:
  RigidMotion(const Contact& contact, const ContactPoints& points, double step, const ObliqueFrame& frame,
              const Obliquity& obliquity);

  /// The positions at the start.
  void start(double compression) { compression_ = compression; }

  /// Kicks and drifts by one step.
  void advance();

  /// Makes these the forces of the kick that is due, and adds the impulses of the step that it ends.
  void load(const Eigen::VectorXd& force, const Eigen::VectorXd& friction);

  /// Where a point moves along the surface by Y and the rotations.
  [[nodiscard]] Eigen::VectorXd along() const;

  [[nodiscard]] double compression() const { return compression_; }
  [[nodiscard]] double force() const { return force_; }

  [[nodiscard]] double velocity() const { return velocity_ - 0.5 * force_ * step_ / frame_.mass; }

  /// Velocities and impulses of the motion along the surface.
  [[nodiscard]] AlongOutcome outcome() const;

 private:
  ObliqueFrame frame_;
  double step_;
  double compression_ = 0.0, shift_ = 0.0;  // X and Y
  double velocity_, tangential_;
  double force_ = 0.0, friction_ = 0.0;         // Σ f and Σ q
  double impulse_ = 0.0;                        // ∫ Σq dt
  std::array<double, 2> spin_, angle_{};        // of each body
  std::array<Eigen::VectorXd, 2> arm_;          // of each point; 0 of a body that does not turn
  std::array<double, 2> moment_{}, moments_{};  // Σ q arm, and its integral
};

}  // namespace stoss
