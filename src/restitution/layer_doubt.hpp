#pragma once

#include "stoss/contact/contact.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Error of 1 − ε² from the coupling of waves in layers that lose energy in different ways, which is left out
/// (docs/theory/plates.md): min(0.1 tan δ, 0.04) of the heat, with the largest tan δ of the layers in the impact. It
/// bounds by how much laminates of glass with PVB and with rubber, and of two plastics, change where the moduli of
/// their waves are those of half or of twice the frequency.
[[nodiscard]] double doubt_of_layers(const Contact& contact, const Run& run);

}  // namespace stoss
