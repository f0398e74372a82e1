#pragma once

#include "stoss/cxx20.hpp"

namespace stoss::quasistatic {

/// Force against compression of a disk that is pressed slowly against a wall. With the force F in πRE and lengths in R
///
///   δ = F (ln(s/F) − b):   center    s = 1, b = (1 + ν)/4   (docs/theory/errata.md, E8)
///                          diameter  s = 4, b = 1           (E7)
///
/// to leading order in F. The paper prints 1 + ν for the latter b (eq. (56)). The exact static contact adds (3 + 3ν/2)
/// F² to the law of the centre (measured; docs/theory/quasistatic.md): 0.1 % of δ = 0.01 R, 0.4 … 0.6 % of δ = 0.03 R.
enum class CompressionLaw {
  center,   ///< approach of the centre of mass to the wall: the one that belongs in its equation of motion
  diameter  ///< shortening of the diameter through the point of contact
};

/// Force at which δ(F) has its maximum, F = s e^{−1−b}: the law ends there, and means little from a tenth of it on.
[[nodiscard]] double limit_force(CompressionLaw law, double poisson);

/// Compression δ(F) by one of the laws, R.
/// @param force F, 0 … limit_force
/// @throws InvalidInput outside that range, and for a Poisson's ratio out of range (−0.95 … 0.995)
[[nodiscard]] double compression(CompressionLaw law, double poisson, double force);

/// Force F(δ) by one of the laws, πRE: the inverse of `compression`, to a relative error of 1e-14.
/// @param compression δ, 0 … compression(law, poisson, limit_force)
/// @throws InvalidInput as compression
[[nodiscard]] double compression_force(CompressionLaw law, double poisson, double compression);

/// Elastic energy ∫F dδ from first contact on, mc²: F² [½ ln(s/F) − ½b − ¼].
/// @param force F, as above
[[nodiscard]] double compression_energy(CompressionLaw law, double poisson, double force);

}  // namespace stoss::quasistatic
