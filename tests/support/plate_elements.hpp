#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bodies/plate/sheet.hpp"
#include "numeric/quadrature.hpp"

namespace stoss::test {

/// All modes of layers at one wave number by another method than that of the library: polynomials of degree 8 on
/// elements through the depth, which make the energies
///   ∫ (λ+2μ)((ku)² + w′²) + 2λ ku w′ + μ(u′ − kw)² dz   and   ∫ ρ(u² + w²) dz
/// stationary, u along the wave and w into the depth; with both faces free.
struct PlateElements {
  std::vector<double> omega;
  std::vector<Eigen::Vector2d> amplitude;  ///< (u, w) of the upper face

  PlateElements(const std::vector<bodies::plate::Sheet>& sheets, double k, int elements_per_layer) {
    constexpr Eigen::Index degree = 8;
    const Eigen::Index elements = static_cast<Eigen::Index>(sheets.size()) * elements_per_layer;
    const Eigen::Index nodes = degree * elements + 1;
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * nodes, 2 * nodes), mass = stiffness;
    const auto& rule = numeric::gauss_legendre(12);
    Eigen::Index first = 0;
    for (const bodies::plate::Sheet& sheet : sheets) {
      const double mu = sheet.shear_modulus, whole = sheet.pressure_modulus, lambda = whole - 2.0 * mu;
      const double length = sheet.thickness / elements_per_layer;
      for (int e = 0; e < elements_per_layer; ++e, first += 2 * degree) {
        for (std::size_t q = 0; q < rule.node.size(); ++q) {
          const auto [value, slope] = shapes(rule.node[q], degree);
          const double weight = 0.5 * length * rule.weight[q], along = 2.0 / length;
          for (Eigen::Index i = 0; i <= degree; ++i) {
            for (Eigen::Index j = 0; j <= degree; ++j) {
              const double vv = weight * value(i) * value(j), ss = weight * along * along * slope(i) * slope(j);
              const double vs = weight * along * value(i) * slope(j), sv = weight * along * slope(i) * value(j);
              const Eigen::Index r = first + 2 * i, c = first + 2 * j;
              stiffness(r, c) += whole * k * k * vv + mu * ss;
              stiffness(r + 1, c + 1) += whole * ss + mu * k * k * vv;
              stiffness(r, c + 1) += lambda * k * vs - mu * k * sv;
              stiffness(r + 1, c) += lambda * k * sv - mu * k * vs;
              mass(r, c) += sheet.density * vv;
              mass(r + 1, c + 1) += sheet.density * vv;
            }
          }
        }
      }
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, mass);
    for (Eigen::Index m = 0; m < 2 * nodes; ++m) {
      omega.push_back(std::sqrt(std::max(modes.eigenvalues()(m), 0.0)));
      amplitude.emplace_back(modes.eigenvectors().col(m).head<2>());
    }
    slow_ = stiffness.ldlt().solve(Eigen::MatrixXd::Identity(2 * nodes, 2)).topRows<2>();
  }

  /// φφᵀ
  [[nodiscard]] Eigen::Matrix2d strength(std::size_t m) const { return amplitude[m] * amplitude[m].transpose(); }

  /// What rounding does to a frequency, relative to it.
  [[nodiscard]] double rounding(std::size_t m) const { return 1e-15 * std::pow(omega.back() / omega[m], 2); }

  /// Displacement of the upper face by slow forces on it.
  [[nodiscard]] const Eigen::Matrix2d& compliance() const { return slow_; }

 private:
  struct Shapes {
    Eigen::VectorXd value, slope;
  };

  /// Lagrange's polynomials of the nodes −cos(πi/n), and their derivatives.
  static Shapes shapes(double x, Eigen::Index degree) {
    const auto node = [&](Eigen::Index i) {
      return -std::cos(std::numbers::pi * static_cast<double>(i) / static_cast<double>(degree));
    };
    Shapes its{Eigen::VectorXd(degree + 1), Eigen::VectorXd::Zero(degree + 1)};
    for (Eigen::Index i = 0; i <= degree; ++i) {
      double value = 1.0, slope = 0.0;
      for (Eigen::Index j = 0; j <= degree; ++j) {
        if (j == i) continue;
        const double apart = 1.0 / (node(i) - node(j));
        slope = slope * (x - node(j)) * apart + value * apart;
        value *= (x - node(j)) * apart;
      }
      its.value(i) = value, its.slope(i) = slope;
    }
    return its;
  }

  Eigen::Matrix2d slow_;
};

}  // namespace stoss::test
