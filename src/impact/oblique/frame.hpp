#pragma once

#include <array>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/impact/oblique.hpp"

namespace stoss {

/// What the motion along the surface has come to, in units of the first body.
struct AlongOutcome {
  double tangential = 0.0;         ///< v_t′
  std::array<double, 2> spin{};    ///< Ω′ of each body
  double impulse = 0.0;            ///< ∫ Σq dt
  std::array<double, 2> moment{};  ///< ∫ Σq arm dt about the centre of each body
  // Energies.
  std::array<double, 2> vibration{};
  double dissipated = 0.0, friction = 0.0, unresolved = 0.0, stored = 0.0;

  /// Energy in the bodies, or that they have lost but to friction.
  [[nodiscard]] double elastic() const { return vibration[0] + vibration[1] + dissipated + unresolved + stored; }
};

/// The motion along the surface at one instant.
struct AlongMotion {
  AlongOutcome outcome;
  double shift = 0.0;             ///< way along y
  std::array<double, 2> angle{};  ///< by which each body has turned
};

/// What moves along the surface besides the modes, in units of the first body: whole bodies, where only a part of one
/// is there (BodyPart).
struct ObliqueFrame {
  double speed;                     ///< v_n
  double mass;                      ///< μ_r along the normal
  double mass_along;                ///< μ_r along the surface
  std::array<double, 2> inertia{};  ///< I of each body; 0: it does not turn
  std::array<double, 2> radius{};   ///< R of each body
  double normal_energy;             ///< at the start, of the motion along the normal and of the vibration
  bool part_of_second;              ///< only a part of the second body is there, as of a plate

  ObliqueFrame(const Contact& contact, double speed, const ImpactOptions& options);

  /// @throws InvalidInput for a motion along the surface, or a friction, out of range
  void require(const Obliquity& obliquity) const;

  /// s
  [[nodiscard]] double sliding(double tangential, double spin, double second_spin) const {
    return tangential + spin * radius[0] + second_spin * radius[1];
  }

  /// Of all motion and of the vibration.
  [[nodiscard]] double initial_energy(const Obliquity& before) const;

  /// The motion along the surface as it was, as without friction.
  [[nodiscard]] static AlongOutcome unchanged(const Obliquity& obliquity);

  /// The motion along the surface of a body that stays on what gives way, in the end. While that takes the rest of its
  /// momentum, friction takes μ times as much, or only what ends the sliding of the rigid bodies.
  /// @param momentum along the normal that is left
  [[nodiscard]] AlongOutcome settled(AlongOutcome now, double friction, double momentum) const;

  /// Change of s by an impulse along the surface.
  [[nodiscard]] double mobility_of_sliding() const;

  /// Velocities and energies of an instant, and the time.
  /// @param velocity of whole bodies along the normal
  /// @param along    the motion along the surface
  /// @param elastic  energy in the bodies beside that of `along`
  [[nodiscard]] ObliqueSnapshot instant(double time, const Obliquity& before, double velocity,
                                        const AlongOutcome& along, double elastic) const;

  /// Both motions as one impact, where they do not act on each other.
  /// @param momentum along the normal that was left to a body that stays, before it came to rest
  [[nodiscard]] ObliqueImpact joined(Impact normal, const Obliquity& before, AlongOutcome after,
                                     double momentum = 0.0) const;
};

/// Arm of friction at each point about the centre of each body, in units of the first; 0 of one that does not turn.
[[nodiscard]] std::array<std::vector<double>, 2> arms(const Contact& contact, const ContactPoints& points);

}  // namespace stoss
