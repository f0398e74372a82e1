#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "impact/oblique/frame.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/oblique.hpp"

namespace stoss {

/// Two bodies as rigid ones, in relative motion under the forces f_i and the friction q_i at points on both sides of
/// the axis, in units of the first:
///
///   μ Ẍ = −Σ f_i,   μ Ÿ = −Σ q_i,   I_k Θ̈_k = −Σ q_i R_k cos φ_i.
///
/// Where only a part of a body is there, with size σ of the whole, it moves as the surface of the whole does at the
/// start, which turns at Ω: at σΩ about its own centre, and by (1 − σ²)ΩR besides.
///
/// By kick, drift, kick: between two steps the velocities are those before the kick that is due, whose two halves end
/// one step and begin the next. All that is read out has half of it.
class RigidMotion {
 public:
  RigidMotion(const Contact& contact, const ContactPoints& points, double step, const ObliqueFrame& frame,
              const Obliquity& obliquity);

  /// The positions at the start.
  void start(double compression) { compression_ = start_compression_ = compression; }

  /// Kicks and drifts by one step.
  void advance();

  /// Makes these the forces of the kick that is due, and adds the impulses of the step that it ends.
  void load(const Eigen::VectorXd& force, const Eigen::VectorXd& friction);

  /// Where a point moves along the surface by Y and the rotations.
  [[nodiscard]] Eigen::VectorXd along() const;

  [[nodiscard]] double compression() const { return compression_; }
  [[nodiscard]] double force() const { return force_; }

  [[nodiscard]] double velocity() const { return velocity_ - 0.5 * force_ * step_ / mass_; }

  /// Velocities of whole bodies along the surface, and impulses. What the whole of a body loses of its energy more than
  /// its part is vibration of it.
  [[nodiscard]] AlongOutcome outcome() const;

  /// Velocity of whole bodies along the normal.
  [[nodiscard]] double whole_velocity() const;

  /// Shows the places and the angles of whole bodies at an instant. @param extent of the contact
  void show(double extent, ObliqueSnapshot& now) const;

 private:
  [[nodiscard]] double energy() const;  // of what is there
  [[nodiscard]] double tangential() const { return tangential_ - 0.5 * friction_ * step_ / mass_; }
  [[nodiscard]] double spin(std::size_t body) const;
  [[nodiscard]] double whole_spin(std::size_t body) const;

  ObliqueFrame frame_;  // of whole bodies
  Obliquity before_;
  double step_;
  double mass_;                             // of what is there, as all that follows
  std::array<double, 2> inertia_{};         // 0: it does not turn
  std::array<bool, 2> part_{};              // whether only a part is there
  double compression_ = 0.0, shift_ = 0.0;  // X and Y
  double velocity_, tangential_;
  double force_ = 0.0, friction_ = 0.0;                         // Σ f and Σ q
  double impulse_ = 0.0;                                        // ∫ Σq dt
  std::array<double, 2> spin_, angle_{};                        // of each body
  std::array<Eigen::VectorXd, 2> arm_;                          // of each point; 0 of a body that does not turn
  std::array<Eigen::VectorXd, 2> whole_arm_;                    // about the centre of the whole body
  std::array<double, 2> moment_{};                              // Σ q arm
  std::array<double, 2> impulse_of_moment_{}, whole_moment_{};  // ∫ Σq arm dt, and Σ q arm about the whole's centre
  std::array<double, 2> whole_angle_{};
  double start_compression_ = 0.0, start_tangential_, start_energy_;
};

}  // namespace stoss
