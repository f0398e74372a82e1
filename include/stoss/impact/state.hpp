#pragma once

#include <vector>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// Motion of what meets: the centre relative to the wall or to the centre of the second body, and the modes, in the
/// order of Contact::groups. A mode of mass m_k, that of its body, has the energy (P² + m_k²ω²Q²)/(2m_k).
struct State {
  double center = 0.0;             ///< x₀, R; the wall is at x = 0, the body at x < 0
  double velocity = 0.0;           ///< of the centre, towards the wall, c
  std::vector<double> coordinate;  ///< Q, R
  std::vector<double> momentum;    ///< P, mc
  double pressed = 0.0;  ///< deepest compression so far of a contact that yields, over that at the onset: its dent
};

/// State after the bodies have touched nothing for a time, forward or back: x₀ drifts and every mode rotates, and
/// decays in a lossy body; back in time it grows.
/// @throws InvalidInput for a time so far back that a vibration of a lossy body exceeds all numbers
[[nodiscard]] State free_motion(const Contact& contact, const State& state, double time);

/// Energy of each mode, mc², in the order of Contact::groups.
/// @throws InvalidInput for a state of another number of modes
[[nodiscard]] std::vector<double> mode_energies(const Contact& contact, const State& state);

/// Distance, R, that the centres must be further apart than at first touch for bodies that vibrate freely not to reach
/// each other at any phase of their modes, or not to feel an exponential wall.
/// @param state its velocity is that of the impact
[[nodiscard]] double clearance(const Contact& contact, const State& state);

}  // namespace stoss
