#pragma once

#include "stoss/contact/contact.hpp"

namespace stoss {

/// How a contact ends: all that an impact asks of it after each step. Times are in R/c of the first body.
struct Ending {
  double longest;    ///< after this time a contact that goes on will not end, but for slow bodies that still vibrate
  double known;      ///< its bodies are what is computed until then: the first echo from where a part of one ends
  bool is_given_up;  ///< what goes on after the longest time has outlasted what is known of its bodies
  bool may_stay;     ///< the surface that is met gives way for good, and a body may stay on it (rebound_of_staying)
  bool foreseen;     ///< how bodies fly on once they are apart can be seen ahead: no wave runs away, nothing is lost
};

[[nodiscard]] Ending ending(const Contact& contact);

}  // namespace stoss
