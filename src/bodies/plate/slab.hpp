#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "bodies/plate/sheet.hpp"
#include "bodies/plate/small_algebra.hpp"

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
  using Matrix = SmallMatrix<T, N>;
  Matrix stiffness;   ///< Q
  Matrix transfer;    ///< F
  Matrix compliance;  ///< G
};

/// A slab that is not thin, f_upper = K q_upper + L q_lower, f_lower = Lᵀ q_upper + SKS q_lower: as it is its own
/// mirror image, S changes the sign of motions along the depth. Waves along one free face, which would be lost among
/// those along the other, are no vibrations of it.
template <typename T, int N>
struct ThickSlab {
  using Matrix = SmallMatrix<T, N>;
  Matrix stiffness;  ///< K
  Matrix through;    ///< L
  int held = 0;      ///< number of its vibrations below z while both faces are held; real z only

  /// SKS
  [[nodiscard]] Matrix lower() const {
    Matrix its = stiffness;
    if constexpr (N == 2) its(0, 1) = its(1, 0) = -its(0, 1);
    return its;
  }
};

/// Stiffness of the upper face of all layers so far.
template <typename T, int N>
struct Face {
  SmallMatrix<T, N> stiffness;
  int held = 0;  ///< number of vibrations below z while this face is held; real z only
};

/// Negative eigenvalues of a symmetric matrix; none of one that is not real.
template <typename T, int N>
[[nodiscard]] int negative(const SmallMatrix<T, N>& matrix) {
  if constexpr (!std::is_same_v<T, double>) {
    return 0;
  } else if constexpr (N == 1) {
    return matrix(0, 0) < 0.0 ? 1 : 0;
  } else {
    return determinant(matrix) < 0.0 ? 1 : matrix(0, 0) + matrix(1, 1) < 0.0 ? 2 : 0;
  }
}

/// Whether its lower face, and the one between two of it, are so stiff against what comes through that few digits are
/// lost.
template <typename T, int N>
[[nodiscard]] bool is_far_from_vibrations(const ThickSlab<T, N>& its) {
  constexpr double close = 1e-3;
  for (int i = 0; i < N; ++i) {
    if (magnitude(its.stiffness(i, i)) < close * magnitude(its.through(i, i))) return false;
  }
  return true;
}

/// Two equal slabs, one on the other. The vibrations of both that are held are as many more as the stiffness of the
/// face between them, which is diagonal, has negative eigenvalues (W. H. Wittrick and F. W. Williams, Q. J. Mech. Appl.
/// Math. 24, 263, 1971).
template <typename T, int N>
[[nodiscard]] ThickSlab<T, N> doubled(const ThickSlab<T, N>& its) {
  using Matrix = typename ThickSlab<T, N>::Matrix;
  Diagonal<T, N> softness;
  int held = 2 * its.held;
  for (int i = 0; i < N; ++i) {
    const T between = 2.0 * its.stiffness(i, i);
    softness(i) = 1.0 / between;
    held += negative(SmallMatrix<T, 1>{{{{between}}}});
  }
  const Matrix moved = its.through * softness;
  return {its.stiffness - moved * transposed(its.through), -1.0 * (moved * its.through), held};
}

template <typename T, int N>
[[nodiscard]] ThickSlab<T, N> thick(const ThinSlab<T, N>& its) {
  using Matrix = typename ThinSlab<T, N>::Matrix;
  const Matrix through = -1.0 * (transposed(its.transfer) * inverse(its.compliance));
  return {its.stiffness - through * its.transfer, through, 0};
}

/// A slab on all layers so far.
template <typename T, int N>
[[nodiscard]] Face<T, N> stacked(const Face<T, N>& below, const ThinSlab<T, N>& its) {
  using Matrix = typename ThinSlab<T, N>::Matrix;
  // The slab by itself has no vibration while its upper face is held.
  const int more = std::is_same_v<T, double> ? negative(below.stiffness + inverse(its.compliance)) : 0;
  const Matrix product = its.compliance * below.stiffness;
  // Of what is stiff the compliance keeps the digits.
  const Matrix both = magnitude(determinant(product)) > 1.0 ? inverse(inverse(below.stiffness) + its.compliance)
                                                            : below.stiffness * inverse(plus(1.0, product));
  return {its.stiffness + transposed(its.transfer) * (both * its.transfer), below.held + more};
}

template <typename T, int N>
[[nodiscard]] Face<T, N> stacked(const Face<T, N>& below, const ThickSlab<T, N>& its) {
  using Matrix = typename ThickSlab<T, N>::Matrix;
  const Matrix between = its.lower() + below.stiffness;
  return {its.stiffness - its.through * inverse(between) * transposed(its.through),
          below.held + its.held + negative(between)};
}

/// A slab of whose lower face one component is held and the other free.
template <typename T, int N>
[[nodiscard]] Face<T, N> held_below(const ThinSlab<T, N>& its, int component) {
  const T stiffness = 1.0 / its.compliance(component, component);
  return {matrix_of<N>([&](int i, int j) {
            return its.stiffness(i, j) + its.transfer(component, i) * stiffness * its.transfer(component, j);
          }),
          0};
}

template <typename T, int N>
[[nodiscard]] Face<T, N> held_below(const ThickSlab<T, N>& its, int component) {
  if (N == 1) return {its.stiffness, its.held};
  const int free = N - 1 - component;
  const T lower = its.stiffness(free, free), compliance = 1.0 / lower;
  return {matrix_of<N>([&](int i, int j) {
            return its.stiffness(i, j) - its.through(i, free) * compliance * its.through(j, free);
          }),
          its.held + negative(SmallMatrix<T, 1>{{{{lower}}}})};
}

/// Of the equations of motion through the depth, q′ = Aq + Dp, p′ = Bq − Aᵀp for the tractions p on planes of constant
/// depth, with D and B diagonal; the depth in units of a thickness.
template <typename T, int N>
struct Equations {
  SmallMatrix<double, N> coupling;  ///< A
  Diagonal<double, N> softness;     ///< D
  Diagonal<T, N> restoring;         ///< B
  T shear, pressure;                ///< squares of the exponents of both waves: the eigenvalues of (A D; B −Aᵀ)²
};

/// Pressure and vertically polarised shear waves, (u, w), u along the wave number and w along the depth:
/// u′ = kw + τ/μ, w′ = (σ − λku)/(λ + 2μ), τ′ = (E′k² − ρz)u + λk/(λ + 2μ) σ, σ′ = −kτ − ρzw, E′ = 4μ(λ + μ)/(λ + 2μ).
/// Horizontally polarised ones, across the wave number: v′ = τ/μ, τ′ = (μk² − ρz)v.
template <int N, typename T>
[[nodiscard]] Equations<T, N> equations(const Sheet& sheet, double k, T z, double thickness) {
  const double mu = sheet.shear_modulus, whole = sheet.pressure_modulus, square = k * k;
  const T inertia = sheet.density * z;
  Equations<T, N> its;
  its.shear = thickness * thickness * (square - 1.0 / mu * inertia);
  its.pressure = thickness * thickness * (square - 1.0 / whole * inertia);
  if constexpr (N == 1) {
    its.softness = {{thickness / mu}};
    its.restoring = {{thickness * (mu * square - inertia)}};
  } else {
    const double lambda = whole - 2.0 * mu, along = 4.0 * mu * (1.0 - mu / whole);
    its.coupling = {{{{0.0, thickness * k}, {-lambda / whole * thickness * k, 0.0}}}};
    its.softness = {{thickness / mu, thickness / whole}};
    its.restoring = {{thickness * (along * square - inertia), -thickness * inertia}};
  }
  return its;
}

/// f(x) and (f(x) − f(y))/(x − y) of f(x) = Σ xⁿ/(2n + odd)!, which is cosh √x or sinh √x/√x, for |x|, |y| < 2.
template <typename T>
[[nodiscard]] std::array<T, 2> hyperbolic(int odd, const T& x, const T& y) {
  constexpr int order = 10;
  constexpr auto inverse_factorial = [] {
    std::array<double, 2 * order + 2> its{1.0};
    for (std::size_t n = 1; n < its.size(); ++n) its[n] = its[n - 1] / static_cast<double>(n);
    return its;
  }();
  T value = 0.0, slope = 0.0;
  for (int n = order; n >= 0; --n) {
    slope = value + y * slope;
    value = inverse_factorial[2 * static_cast<std::size_t>(n) + static_cast<std::size_t>(odd)] + x * value;
  }
  return {value, slope};
}

/// A slab of small phase, from the exponential of M = (A D; B −Aᵀ). In e^M = cosh M + M (sinh M)/M both functions are
/// even, and f(M²) = f(x) + (M² − x) (f(x) − f(y))/(x − y) if M² has the eigenvalues x and y.
template <typename T, int N>
[[nodiscard]] ThinSlab<T, N> thin_slab(const Equations<T, N>& its) {
  using Matrix = typename ThinSlab<T, N>::Matrix;
  const auto [cosh, cosh_slope] = hyperbolic<T>(0, its.shear, its.pressure);
  const auto [sinh, sinh_slope] = hyperbolic<T>(1, its.shear, its.pressure);
  const auto& [coupling, softness, restoring, shear, pressure] = its;
  // M² − x = (even, upper; lower, even), even diagonal
  Diagonal<T, N> even, odd;
  for (int i = 0; i < N; ++i) {
    const T square = (coupling * coupling)(i, i) + softness(i) * restoring(i) - shear;
    even(i) = cosh + cosh_slope * square;
    odd(i) = sinh + sinh_slope * square;
  }
  const auto upper = coupling * softness - softness * transposed(coupling);
  const Matrix lower = restoring * coupling - transposed(coupling) * restoring;
  // e^M = (…, to_q; of_q, of_p)
  const Matrix to_q = softness * odd + (cosh_slope * upper + sinh_slope * (coupling * upper));
  const Matrix of_q = restoring * odd + (cosh_slope * lower - sinh_slope * (transposed(coupling) * lower));
  const Matrix of_p = even + (sinh_slope * (restoring * upper) - transposed(coupling) * odd);
  const Matrix back = inverse(of_p);
  return {back * of_q, transposed(back), to_q * back};
}

/// The face of a whole layer: a slab of small phase, doubled, and at the end one of which it is no multiple. Slabs of
/// h/2, h/4 … would have vibrations of their own where the layer has some, and these would lose digits.
/// @param on what a slab, thin or thick, makes of the face below the layer
template <int N, typename T, typename On>
[[nodiscard]] Face<T, N> layer_face(const Sheet& sheet, double k, T z, const On& on) {
  constexpr double thin = 0.96;  // phase of a slab that has no vibration, whatever of it is held
  const double square = magnitude(z) * sheet.density / sheet.shear_modulus;
  const double phase = sheet.thickness * std::max(k, std::sqrt(square));
  const auto thin_slab_of = [&](double thickness) { return thin_slab(equations<N, T>(sheet, k, z, thickness)); };
  if (phase <= thin) return on(thin_slab_of(sheet.thickness));
  const int least = static_cast<int>(std::ceil(std::log2(std::max(phase / thin - 1.0, 1.0))));
  constexpr int more = 4;  // to be tried if some of the slabs happen to have a vibration very near to z
  for (int doublings = least;; ++doublings) {
    const auto slab = thin_slab_of(sheet.thickness / (std::ldexp(1.0, doublings) + 1.0));
    ThickSlab<T, N> all = thick(slab);
    bool is_safe = is_far_from_vibrations(all);
    for (int n = 0; n < doublings; ++n) {
      all = doubled(all);
      is_safe = is_safe && is_far_from_vibrations(all);
    }
    if (is_safe || doublings == least + more) return stacked(on(all), slab);
  }
}

}  // namespace stoss::bodies::plate
