#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

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
  RigidMotion(const Contact& contact, const ContactPoints& points, double step, double speed,
              const Obliquity& obliquity);

  /// The positions at the start.
  void start(double compression) { compression_ = compression; }

  /// Kicks and drifts by one step.
  void advance();

  /// Makes these the forces of the kick that is due, and adds the impulses of the step that it ends.
  void load(const Eigen::VectorXd& force, const Eigen::VectorXd& friction);

  /// Where a point moves along the surface by Y and the rotations.
  [[nodiscard]] Eigen::VectorXd along(Eigen::Index points) const;

  [[nodiscard]] double compression() const { return compression_; }
  [[nodiscard]] double force() const { return force_; }

  [[nodiscard]] double velocity() const { return velocity_ - 0.5 * force_ * step_ / mass_; }
  [[nodiscard]] double tangential() const { return tangential_ - 0.5 * friction_ * step_ / mass_; }
  [[nodiscard]] double spin(std::size_t body) const;

  /// v_t + Ω₁R₁ + Ω₂R₂
  [[nodiscard]] double sliding() const;

  /// Energies of translation along and across the normal, and of a body's rotation.
  [[nodiscard]] double energy_along_normal() const { return 0.5 * mass_ * velocity() * velocity(); }
  [[nodiscard]] double energy_across() const { return 0.5 * mass_ * tangential() * tangential(); }
  [[nodiscard]] double energy_of_rotation(std::size_t body) const;

  /// Fills what the motion is like, and by how much impulses and momenta differ.
  void show(const Obliquity& before, ObliqueImpact& impact) const;

 private:
  struct Turning {
    double inertia = 0.0;  // 0: it does not turn
    double radius = 0.0;   // of the foremost point
    Eigen::VectorXd arm;   // of each point
    double rate = 0.0;
    double angle = 0.0;
    double moment = 0.0;   // of the friction
    double impulse = 0.0;  // ∫ moment dt
  };
  [[nodiscard]] static Turning turning(const Contact& contact, const ContactPoints& points, int body, double rate);

  double mass_, step_, speed_;
  double compression_ = 0.0, shift_ = 0.0;
  double velocity_, tangential_;
  double force_ = 0.0, friction_ = 0.0;
  double friction_impulse_ = 0.0;
  std::array<Turning, 2> turning_;
};

}  // namespace stoss
