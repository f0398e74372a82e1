#pragma once

#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/impact/state.hpp"

namespace stoss {

/// A mode that vibrates before an impact, Q = A cos(ωt + φ), with t = 0 when the unexcited bodies would touch.
struct Oscillation {
  int body = 0;         ///< 0: of the first, 1: of the second
  int order = 0;        ///< n
  int index = 0;        ///< l
  double energy = 0.0;  ///< ½ m_k ω² A², as a share of the translational energy ½μv²; 0 or more
  double phase = 0.0;   ///< φ, radians
};

/// How bodies vibrate before an impact, whatever the cutoff at which it is computed. Modes that are not named rest.
using Vibration = std::vector<Oscillation>;

/// State of bodies that approach each other and vibrate, before they can have touched: shortly before they may, or at
/// the clearance in a lossy material, whose modes have at that instant the energies that they are given; only their
/// phases are followed back.
/// @param speed of approach, as for `impact`
/// @throws InvalidInput for a speed out of range, a mode that the bodies do not have or that comes twice, an energy
///         that is negative or not finite, a phase that is not finite, and bodies of which only a part is there
///         (half-spaces, much larger bodies)
[[nodiscard]] State approach(const Contact& contact, double speed, const Vibration& vibration);

/// How the bodies of a state vibrate that approach each other or part, in the order of its modes: the inverse of
/// `approach`. Modes at rest are left out.
/// @throws InvalidInput for a state of another number of modes or of bodies that do not move
[[nodiscard]] Vibration vibration(const Contact& contact, const State& state);

/// How bodies that part vibrate when they meet again at the speed of their parting, after a flight from where they
/// would have parted unexcited to where they would touch. In a lossy material they vibrate less by then. What is
/// left in a body of which only a part is there has left.
/// @param flight its time, R/c, 0 or more
/// @throws InvalidInput as `vibration`, and for a flight that is negative or not finite
[[nodiscard]] Vibration vibration_after(const Contact& contact, const State& state, double flight);

/// Whether a contact keeps all modes of a vibration.
/// @throws InvalidInput for a mode of a body that is not there, or of which only a part is, and for one that no cutoff
///         would keep
[[nodiscard]] bool keeps(const Contact& contact, const Vibration& vibration);

}  // namespace stoss
