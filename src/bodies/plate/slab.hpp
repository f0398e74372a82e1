#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "bodies/plate/pair_number.hpp"
#include "bodies/plate/sheet.hpp"

namespace stoss::bodies::plate {

/// A slab of a layer at one wave number and at z = ω², thin against its waves: what moves its faces, in N components of
/// displacement q and of force f per area on a face, of which
///
///   f_upper = Q q_upper − Fᵀ f_lower,   q_lower = F q_upper + G f_lower.
///
/// Q is the stiffness of the upper face while the lower one is free, G the compliance of the lower face while the upper
/// one is held. Both are small, so that no digits are lost in bending.
template <typename T, int N>
struct ThinSlab {
  using Matrix = Eigen::Matrix<T, N, N>;
  Matrix stiffness;   ///< Q
  Matrix transfer;    ///< F
  Matrix compliance;  ///< G
};

/// A slab that is not thin, f_upper = K_uu q_upper + K_ul q_lower, f_lower = K_ulᵀ q_upper + K_ll q_lower. Waves along
/// one free face, which would be lost among those along the other, are no vibrations of it.
template <typename T, int N>
struct ThickSlab {
  using Matrix = Eigen::Matrix<T, N, N>;
  Matrix upper;    ///< K_uu
  Matrix through;  ///< K_ul
  Matrix lower;    ///< K_ll
  int held = 0;    ///< number of its vibrations below z while both faces are held; real z only
};

/// Stiffness of the upper face of all layers so far.
template <typename T, int N>
struct Face {
  Eigen::Matrix<T, N, N> stiffness;
  int held = 0;  ///< number of vibrations below z while this face is held; real z only
};

/// Negative eigenvalues of a symmetric matrix; none of one that is not real.
template <typename T, int N>
[[nodiscard]] int negative(const Eigen::Matrix<T, N, N>& matrix) {
  if constexpr (!std::is_same_v<T, double>) {
    return 0;
  } else if constexpr (N == 1) {
    return matrix(0, 0) < 0.0 ? 1 : 0;
  } else {
    return matrix.determinant() < 0.0 ? 1 : matrix.trace() < 0.0 ? 2 : 0;
  }
}

/// Two equal slabs, one on the other.
template <typename T, int N>
[[nodiscard]] ThinSlab<T, N> doubled(const ThinSlab<T, N>& its) {
  using Matrix = typename ThinSlab<T, N>::Matrix;
  const Matrix inverse = (Matrix::Identity() + its.compliance * its.stiffness).inverse();
  const Matrix moved = inverse * its.transfer;
  return {its.stiffness + its.transfer.transpose() * (its.stiffness * moved), its.transfer * moved,
          its.compliance + its.transfer * (inverse * its.compliance) * its.transfer.transpose()};
}

/// The same. The vibrations of both that are held are as many more as the stiffness of the face between them has
/// negative eigenvalues (W. H. Wittrick and F. W. Williams, Q. J. Mech. Appl. Math. 24, 263, 1971).
template <typename T, int N>
[[nodiscard]] ThickSlab<T, N> doubled(const ThickSlab<T, N>& its) {
  using Matrix = typename ThickSlab<T, N>::Matrix;
  const Matrix between = its.lower + its.upper, inverse = between.inverse();
  return {its.upper - its.through * inverse * its.through.transpose(), -its.through * inverse * its.through,
          its.lower - its.through.transpose() * inverse * its.through, 2 * its.held + negative(between)};
}

template <typename T, int N>
[[nodiscard]] ThickSlab<T, N> thick(const ThinSlab<T, N>& its) {
  using Matrix = typename ThinSlab<T, N>::Matrix;
  const Matrix lower = its.compliance.inverse(), through = -its.transfer.transpose() * lower;
  return {its.stiffness - through * its.transfer, through, lower, 0};
}

/// A slab on all layers so far.
template <typename T, int N>
[[nodiscard]] Face<T, N> stacked(const Face<T, N>& below, const ThinSlab<T, N>& its) {
  using Matrix = typename ThinSlab<T, N>::Matrix;
  const Matrix inverse = (Matrix::Identity() + its.compliance * below.stiffness).inverse();
  // The slab by itself has no vibration while its upper face is held.
  const int more = std::is_same_v<T, double> ? negative<T, N>(below.stiffness + its.compliance.inverse()) : 0;
  // Of what is stiff the compliance keeps the digits.
  const Matrix both = magnitude(Matrix(its.compliance * below.stiffness).determinant()) > 1.0
                          ? Matrix(Matrix(below.stiffness.inverse() + its.compliance).inverse())
                          : Matrix(below.stiffness * inverse);
  return {its.stiffness + its.transfer.transpose() * both * its.transfer, below.held + more};
}

template <typename T, int N>
[[nodiscard]] Face<T, N> stacked(const Face<T, N>& below, const ThickSlab<T, N>& its) {
  using Matrix = typename ThickSlab<T, N>::Matrix;
  const Matrix between = its.lower + below.stiffness;
  return {its.upper - its.through * between.inverse() * its.through.transpose(),
          below.held + its.held + negative(between)};
}

/// A slab of whose lower face one component is held and the other free.
template <typename T, int N>
[[nodiscard]] Face<T, N> held_below(const ThinSlab<T, N>& its, int component) {
  const Eigen::Matrix<T, N, 1> moved = its.transfer.row(component).transpose();
  return {its.stiffness + moved * (T(1.0) / its.compliance(component, component)) * moved.transpose(), 0};
}

template <typename T, int N>
[[nodiscard]] Face<T, N> held_below(const ThickSlab<T, N>& its, int component) {
  if (N == 1) return {its.upper, its.held};
  const int free = N - 1 - component;
  const Eigen::Matrix<T, N, 1> through = its.through.col(free);
  Eigen::Matrix<T, 1, 1> lower;
  lower(0, 0) = its.lower(free, free);
  return {its.upper - through * (T(1.0) / lower(0, 0)) * through.transpose(), its.held + negative<T, 1>(lower)};
}

/// Of the equations of motion through the depth, q′ = Aq + Dp, p′ = Bq − Aᵀp for the tractions p on planes of constant
/// depth, with D and B diagonal.
template <typename T, int N>
struct Equations {
  Eigen::Matrix<double, N, N> coupling;  ///< A
  Eigen::Matrix<double, N, 1> softness;  ///< D
  Eigen::Matrix<T, N, 1> restoring;      ///< B
};

/// Pressure and vertically polarised shear waves, (u, w), u along the wave number and w along the depth:
/// u′ = kw + τ/μ, w′ = (σ − λku)/(λ + 2μ), τ′ = (E′k² − ρz)u + λk/(λ + 2μ) σ, σ′ = −kτ − ρzw, E′ = 4μ(λ + μ)/(λ + 2μ).
/// Horizontally polarised ones, across the wave number: v′ = τ/μ, τ′ = (μk² − ρz)v.
template <int N, typename T>
[[nodiscard]] Equations<T, N> equations(const Sheet& sheet, double k, T z) {
  const double mu = sheet.shear_modulus, whole = sheet.pressure_modulus, inertia = sheet.density;
  Equations<T, N> its;
  if constexpr (N == 1) {
    its.coupling(0, 0) = 0.0;
    its.softness(0) = 1.0 / mu;
    its.restoring(0) = mu * k * k - inertia * z;
  } else {
    const double lambda = whole - 2.0 * mu;
    its.coupling << 0.0, k, -lambda / whole * k, 0.0;
    its.softness << 1.0 / mu, 1.0 / whole;
    its.restoring << 4.0 * mu * (1.0 - mu / whole) * k * k - inertia * z, -inertia * z;
  }
  return its;
}

/// A slab so thin that the power series in its thickness s ends at rounding, from the equations of Riccati
/// Q′ = B + AᵀQ + QA − QDQ, F′ = F(A − DQ), G′ = FDFᵀ.
template <typename T, int N>
[[nodiscard]] ThinSlab<T, N> series(const Equations<T, N>& its, double thickness) {
  using Matrix = typename ThinSlab<T, N>::Matrix;
  constexpr std::size_t order = 7;
  std::array<Matrix, order + 1> stiffness, transfer, compliance, flow;  // terms of the series; flow: A − DQ
  stiffness[0] = compliance[0] = Matrix::Zero();
  transfer[0] = Matrix::Identity();
  const Matrix coupling = its.coupling.template cast<T>();
  const auto softness = its.softness.template cast<T>().asDiagonal();
  for (std::size_t n = 0; n < order; ++n) {
    flow[n] = -(softness * stiffness[n]);
    if (n == 0) flow[n] += coupling;
    Matrix q = coupling.transpose() * stiffness[n], f = Matrix::Zero(), g = Matrix::Zero();
    if (n == 0) q.diagonal() += its.restoring;
    for (std::size_t i = 0; i <= n; ++i) {
      q += stiffness[i] * flow[n - i];
      f += transfer[i] * flow[n - i];
      g += transfer[i] * softness * transfer[n - i].transpose();
    }
    const double share = thickness / static_cast<double>(n + 1);
    stiffness[n + 1] = share * q;
    transfer[n + 1] = share * f;
    compliance[n + 1] = share * g;
  }
  ThinSlab<T, N> slab{Matrix::Zero(), Matrix::Zero(), Matrix::Zero()};
  for (std::size_t n = order + 1; n-- > 0;) {
    slab.stiffness += stiffness[n];
    slab.transfer += transfer[n];
    slab.compliance += compliance[n];
  }
  return slab;
}

/// The face of a whole layer: a very thin slab, doubled until it is thick, and at the end one of which it is no
/// multiple. Slabs of h/2, h/4 … would have vibrations of their own where the layer has some, and these would lose
/// digits.
/// @param on what a slab, thin or thick, makes of the face below the layer
template <int N, typename T, typename On>
[[nodiscard]] Face<T, N> layer_face(const Sheet& sheet, double k, T z, const On& on) {
  constexpr double thinnest = 0.0075;  // phase across the first slab
  constexpr int thin_doublings = 7;    // up to a phase of 1, at which it has no vibration, whatever of it is held
  constexpr int thin_slabs = 1 << thin_doublings;
  const double square = magnitude(z) * sheet.density / sheet.shear_modulus;
  const double slabs = sheet.thickness * std::max(k, std::sqrt(square)) / thinnest;
  const bool is_thin = slabs <= thin_slabs;
  const double more = is_thin ? 1.0 : std::max(slabs - thin_slabs, 1.0 * thin_slabs);
  const int doublings = slabs <= 1.0 ? 0 : static_cast<int>(std::ceil(std::log2(is_thin ? slabs : more)));
  const double count = std::ldexp(1.0, doublings) + (is_thin ? 0 : thin_slabs);
  ThinSlab<T, N> thin = series<T, N>(equations<N, T>(sheet, k, z), sheet.thickness / count);
  for (int n = 0; n < std::min(doublings, thin_doublings); ++n) thin = doubled(thin);
  if (is_thin) return on(thin);
  ThickSlab<T, N> all = thick(thin);
  for (int n = thin_doublings; n < doublings; ++n) all = doubled(all);
  return stacked(on(all), thin);
}

}  // namespace stoss::bodies::plate
