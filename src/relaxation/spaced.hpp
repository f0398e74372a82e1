#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "stoss/relaxation.hpp"

/// What the fits of Prony series share.
namespace stoss {

/// iωτ/(1 + iωτ), the modulus of a term.
[[nodiscard]] std::complex<double> modulus_of_term(double frequency, double time);

/// `count` numbers from low to high, each by the same factor above the one before.
[[nodiscard]] std::vector<double> spaced(double low, double high, int count);

/// The relaxation of these moduli E_j and, last, E∞.
[[nodiscard]] Relaxation of_moduli(const Eigen::VectorXd& moduli, const std::vector<double>& times);

}  // namespace stoss
