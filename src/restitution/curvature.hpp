#pragma once

#include <string>

#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// What the near side of a body leaves out of ε: that its edge is more curved for waves than that of the whole.
///
/// ε depends on the curvature 1/size of the part as a power series (docs/theory/pairs.md). Three parts, each of twice
/// the size of the one before or the whole, give the coefficients with which it is extrapolated to the curvature of the
/// whole. They hardly depend on the cutoff.
struct CurvatureCorrection {
  double shift = 0.0;  ///< of ε
  double error = 0.0;  ///< of the shift: what the second power changes, and a coarser cutoff
};

/// The correction at a speed, from six coarse impacts; none where both bodies are whole.
/// @throws as impact
[[nodiscard]] CurvatureCorrection curvature_correction(const RefinableContact& contact, double speed, const Poll& poll);

/// Applies it to ε, to the translation and to the loss of the body that is a part.
void correct(const CurvatureCorrection& correction, const Contact& contact, Impact& impact);

/// What of the error of 1 − ε² comes from the correction.
[[nodiscard]] double neglected(const CurvatureCorrection& correction, const Impact& impact);

/// Why no cutoff meets the tolerance, if the correction stands in the way; else empty.
[[nodiscard]] std::string out_of_reach(const CurvatureCorrection& correction, const Restitution& result);

}  // namespace stoss
