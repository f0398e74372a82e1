#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "impact/oblique/frame.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

/// Two bodies along their surfaces under the friction q_i at points of the contact, in units of the first:
///
///   μ Ÿ = −Σ q_i,   I_k Θ̈_k = −Σ q_i a_ki,   with a_ki the arm of point i about the centre of body k,
///
/// by half a kick, drift and half a kick. Turning moves points along y only (linear kinematics).
///
/// Where only a part of a body is there, with size σ of the whole, it moves as the surface of the whole does at the
/// start, which turns at Ω: at σΩ about its own centre, and by (1 − σ²)ΩR besides. The whole is turned by the moment
/// about its own centre.
class TangentialMotion {
 public:
  /// The motion of whole bodies. @param arm of each point (arms)
  TangentialMotion(const ObliqueFrame& frame, const std::array<std::vector<double>, 2>& arm, double step,
                   const Obliquity& before);

  /// Of what is there of each body, at points on both sides of the axis.
  TangentialMotion(const Contact& contact, const ContactPoints& points, const ObliqueFrame& frame, double step,
                   const Obliquity& before);

  /// Half a kick, and drifts by one step.
  void advance();

  /// Makes this the friction, and kicks by half a step.
  template <typename Values>
  void load(const Values& friction) {
    friction_ = friction.sum();
    for (std::size_t k = 0; k < 2; ++k) {
      if (frame_.inertia[k] == 0.0) continue;
      moment_[k] = friction.dot(arm_[k]);
      whole_moment_[k] = part_[k] ? friction.dot(whole_arm_[k]) : moment_[k];
    }
    kick();
  }

  /// Puts the points along y where they are.
  template <typename Values>
  void place(Values& points) const {
    Eigen::Index k = 0;
    for (double& point : points) {
      point = shift_ + angle_[0] * arm_[0](k) + angle_[1] * arm_[1](k);
      ++k;
    }
  }

  /// Velocities of whole bodies, and impulses.
  [[nodiscard]] AlongOutcome outcome() const;

  /// Ways of whole bodies by now.
  [[nodiscard]] AlongMotion motion(double time) const;

  /// Energy of what is there.
  [[nodiscard]] double energy() const;

 private:
  void kick();

  ObliqueFrame frame_;  // of whole bodies
  double step_, mass_;  // of what is there
  std::array<double, 2> inertia_;
  std::array<bool, 2> part_{};
  std::array<Eigen::VectorXd, 2> arm_, whole_arm_;  // 0 of a body that does not turn
  double before_;                                   // Y' of whole bodies
  double start_, tangential_, shift_ = 0.0;
  std::array<double, 2> spin_, angle_{}, whole_spin_, whole_angle_{};
  double friction_ = 0.0, impulse_ = 0.0;                         // Σ q, ∫ Σq dt
  std::array<double, 2> moment_{}, whole_moment_{}, impulses_{};  // Σ q a; of wholes, and its integral
};

}  // namespace stoss
