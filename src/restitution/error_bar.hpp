#pragma once

#include <string_view>
#include <vector>

#include "restitution/curvature.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// One part of an error bar.
struct Term {
  std::string_view constant;  ///< of calibration.hpp by which it is multiplied; empty: none
  double in_use = 0.0;        ///< that constant
  double error = 0.0;         ///< the part
};

/// A value with its error, which is the greatest of its terms.
struct Bar {
  Estimate Restitution::*estimate;
  double value;
  std::vector<Term> terms;

  [[nodiscard]] const Term& greatest() const;
};

/// Those of all that a result estimates from its runs, 1 − ε² first, as far as they follow from constants.
[[nodiscard]] std::vector<Bar> error_bars(const Contact& contact, double speed, const Restitution& result);

/// Order of convergence of 1 − ε² in the cutoff, as observed: with one point of contact the force jumps, on a surface
/// it grows, and slower where lossy bodies have a sharp edge.
[[nodiscard]] double convergence_order(const Contact& contact, double speed);

/// By what the loss changes with the compliance of what is met, relative to it: a half-space takes in proportion, and a
/// plate leaves a rebound ε² = 1 − q that falls exponentially with it, as in Zener's theory.
[[nodiscard]] double sensitivity(const Contact& contact, double lost);

/// Fills the estimates of a result from its runs, of which the last is the finest (docs/developer/numerics.md, section
/// 5).
///
/// What an impact at a finite cutoff lacks is what the modes above it, which take the energy U for good, would have
/// given back. With the share s of U (`missing`), 1 − ε² is q − sU, and its error the greater of a part of U and of
/// the differences from the coarser runs, scaled to what is left of them at the last cutoff:
///
///   max(0.8 s U + n U, e s₀ U, 3 max_j |q_j − q_k| (ω_j/ω_k)^{5/2}),   n the noise of a single run,
///
/// s₀ the share s without its fall at high speed and e = (v/0.33)⁴, at most 3.5; s and n of balls are others, with
/// e = 0.6;
///   at one point of contact max(U/2, 6 max_j |q_j − q_k| ω_j/ω_k).
///
/// Of lossy bodies, which dissipate D, it is at least C D/(n (1 + 2ηn/t))² with n nodes and the contact time t, C = 12
/// of balls and 2.1 of disks (docs/theory/loss.md), and the power of the differences is 1.75.
///
/// What the near side of a much larger body leaves out adds to the error.
void conclude(const Contact& contact, double speed, const CurvatureCorrection& correction, Restitution& result);

/// Widens the error of ε and 1 − ε² by what the laws of layers and of yield leave open, which no cutoff changes.
void add_doubt_of_laws(const Contact& contact, Restitution& result);

/// Widens the error of ε and 1 − ε² by what fewer points than `restitution` takes on half-spaces and plates leave open.
void add_spacing(const Contact& contact, Restitution& result);

}  // namespace stoss
