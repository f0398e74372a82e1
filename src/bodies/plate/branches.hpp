#pragma once

#include <Eigen/Core>
#include <vector>

#include "bodies/plate/sheet.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::plate {

/// The upper face of a plate at one wave number k, whose lower face is free: all modes below a cutoff, and the answer
/// of the others to slow forces.
///
/// A traction p moves the face by Σ φφᵀ p/(ω_m² − ω²), φ the amplitudes of a mode on it, of N components: 2 of pressure
/// and vertically polarised shear waves (along k, into the depth), 1 of shear waves across k.
template <int N>
struct Branches {
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  std::vector<double> omega;      ///< of the modes below the cutoff, rising
  std::vector<Vector> amplitude;  ///< φ: per root of mass per area
  Matrix compliance;              ///< Σ φφᵀ/ω² of the modes above it
  Matrix second_moment;           ///< Σ φφᵀ/ω⁴ of these
};

/// Finds them.
///
/// A mode is a root of the determinant of the stiffness Q(ω²), and φφᵀ its residue. The number of modes below any
/// frequency is counted exactly (Wittrick and Williams): the roots that Newton's method finds near the guesses are all
/// of them if they are as many; else the others are isolated by counts, so that none is missed. What is above the
/// cutoff follows from mean values of R(z) = Q⁻¹(z) − Σ φφᵀ/(ω² − z), which has no singularity up to there, on a
/// circle: R(0) and R′(0).
/// @param guess frequencies near which modes may be: those of a wave number nearby, or none
template <int N>
[[nodiscard]] Branches<N> branches(const Sheets& sheets, double wave_number, double cutoff,
                                   const std::vector<double>& guess, const Poll& poll = {});

/// Number of modes below a frequency.
template <int N>
[[nodiscard]] int count_below(const Sheets& sheets, double wave_number, double omega);

/// Static compliance of the upper face: of all modes together.
template <int N>
[[nodiscard]] Eigen::Matrix<double, N, N> static_compliance(const Sheets& sheets, double wave_number);

/// Σ φφᵀ/ω⁴ of all modes.
template <int N>
[[nodiscard]] Eigen::Matrix<double, N, N> static_second_moment(const Sheets& sheets, double wave_number);

}  // namespace stoss::bodies::plate
