#pragma once

#include "stoss/relaxation.hpp"

namespace stoss {

/// Relaxation of a material whose quality Q is the same at all frequencies of a band, E″/E′ = 1/Q.
///
///   M(iω) ∝ (iω)^{2γ/π},   γ = atan(1/Q)
///
/// It is approached by terms with times equally spaced on a logarithmic scale, as few as keep 1/Q within 1 % over the
/// band: 7 for three decades and 10 for five where Q is 10 or more, 15 for five where it is 3. E″ and E′ are fitted by
/// least squares with shares above 0. Below the band the material becomes elastic with E∞, above it with E(0).
/// @param quality Q, 3 to 1e9
/// @param lowest,highest of the band, angular frequencies; times are in one over their unit
/// @throws InvalidInput for other numbers, and for a band that takes more than most_relaxation_terms
[[nodiscard]] Relaxation constant_quality(double quality, double lowest, double highest);

/// E(0) of such a material over its modulus at a frequency, which beyond the band goes on as |E| ∝ ω^{2γ/π}.
/// @param relaxation as constant_quality of the same quality makes it
[[nodiscard]] double instantaneous(const Relaxation& relaxation, double quality, double frequency);

/// Band of a body in c/R: contacts of all speeds that are computed, 1e-8 to 1 c, last 200 to 5 R/c and less at a
/// smaller partner. What a wider one changes of ε is in docs/theory/loss.md.
inline constexpr double lowest_of_body = 5e-4, highest_of_body = 50.0;

}  // namespace stoss
