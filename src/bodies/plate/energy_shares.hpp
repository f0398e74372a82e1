#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "bodies/plate/sheet.hpp"

namespace stoss::bodies::plate {

/// Shares of a mode's strain energy in the layers of each kind, which add up to 1.
///
/// By Rayleigh's principle they are (E/ω²) ∂ω²/∂E at fixed wave number, with E multiplying all moduli of a kind, and
/// ∂ω²/∂E = φᵀ (∂Q/∂E) φ for the amplitudes φ on the upper face, φᵀ (∂Q/∂ω²) φ = −1.
/// @param amplitude φ, to any factor
template <int N>
[[nodiscard]] std::vector<double> energy_shares(const Sheets& sheets, double wave_number, double omega,
                                                const Eigen::Matrix<double, N, 1>& amplitude, std::size_t kinds);

/// Shares of the layers of each kind in the energy under a slow load on the upper face, across the layers (N = 2) or
/// along them: −(E/C) ∂C/∂E of its compliance C, times C.
template <int N>
[[nodiscard]] std::vector<double> static_energies(const Sheets& sheets, double wave_number, std::size_t kinds);

}  // namespace stoss::bodies::plate
