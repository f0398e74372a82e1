#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "stoss/impact/impact.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// How what still vibrates after an impact is heard.
struct SoundOptions {
  int body = 0;                     ///< whose struck point moves, 0: of the first, 1: of the second body
  double interval = 0.0;            ///< between two samples, R/c of the first
  std::size_t count = 0;            ///< of samples, the first at the end of the impact
  std::optional<double> quality{};  ///< Q of every mode in place of that of its material
};

/// Velocity of the struck point of a body, by its kept modes, after an impact: towards what it has met, c of the first.
///
///   v(t) = Σ u_k e^(−γ_k t) [P_k/m cos ω_k t − ω_k Q_k sin ω_k t],   γ = ½ η ω², or ω/(2 Quality)
///
/// with the displacement u_k of the point in the mode k. Modes above π/interval, which samples cannot tell from lower
/// ones, are left out.
/// @throws InvalidInput for a body that is not there, or of which only a part is; and for numbers out of range
[[nodiscard]] std::vector<double> sound(const Contact& contact, const Impact& impact, const SoundOptions& options,
                                        const Poll& poll = {});

}  // namespace stoss
