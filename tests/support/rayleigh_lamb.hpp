#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

namespace stoss::test {

using Exact = boost::multiprecision::cpp_bin_float_100;

/// A plate of one material in the textbook's closed forms, in numbers of any precision.
template <typename Real>
struct ClosedForm {
  Real half;                     ///< H, half of the thickness
  Real shear_modulus;            ///< μ
  Real pressure_speed, density;  ///< c_p, ρ

  [[nodiscard]] Real shear_square() const { return shear_modulus / density; }
};

/// Of Young's modulus and Poisson's ratio; in the plane both are 2-D.
template <typename Real>
ClosedForm<Real> closed_form(double thickness, double poisson, double young, double density, bool in_plane) {
  const Real nu = poisson, e = young, rho = density;
  const Real modulus = in_plane ? Real(e / (1 - nu * nu)) : Real(e * (1 - nu) / ((1 + nu) * (1 - 2 * nu)));
  return {Real(thickness) / 2, e / (2 * (1 + nu)), sqrt(Real(modulus / rho)), rho};
}

enum class Kind { symmetric, antisymmetric };

/// A response N(z)/D(z) at z = ω², whose poles are the roots of D.
template <typename Real>
struct Fraction {
  Real numerator, denominator;
};

/// cosh √s H, and sinh √s H/√s, of any s.
template <typename Real>
struct Hyperbolic {
  Real even, odd;

  Hyperbolic(const Real& square, const Real& half) {
    using std::abs, std::sqrt, std::cos, std::sin, std::exp;
    const Real root = sqrt(abs(square));
    if (square < 0) {
      even = cos(root * half), odd = sin(root * half) / root;
    } else {
      const Real up = exp(root * half), down = 1 / up;
      even = (up + down) / 2, odd = root == 0 ? half : Real((up - down) / (2 * root));
    }
  }
};

/// w_S or w_A: how far a pressure 1 on both faces, in the same or in the opposite sense, moves them, from Rayleigh and
/// Lamb: with α² = k² − z/c_p², β² = k² − z/c_s²,
///   w_S = −α(k² − β²) sinh αH sinh βH/μ / [(k² + β²)² cosh αH sinh βH − 4k²αβ sinh αH cosh βH],
///   w_A = −α(k² − β²) cosh αH cosh βH/μ / [(k² + β²)² sinh αH cosh βH − 4k²αβ cosh αH sinh βH],
/// the first divided by β, the second by α, above and below, so that all is real.
template <typename Real>
Fraction<Real> rayleigh_lamb(const ClosedForm<Real>& its, Kind kind, const Real& k, const Real& z) {
  const Real kk = k * k, shear = z / its.shear_square();
  const Real a = kk - z / (its.pressure_speed * its.pressure_speed), b = kk - shear;
  const Hyperbolic<Real> of_a(a, its.half), of_b(b, its.half);
  const Real square = (kk + b) * (kk + b);
  if (kind == Kind::symmetric) {
    return {-shear / its.shear_modulus * a * of_a.odd * of_b.odd,
            square * of_a.even * of_b.odd - 4 * kk * a * of_a.odd * of_b.even};
  }
  return {-shear / its.shear_modulus * of_a.even * of_b.even,
          square * of_a.odd * of_b.even - 4 * kk * b * of_a.even * of_b.odd};
}

/// Its limit for slow forces, with x = kH: (1 − ν)/(μk) (cosh 2x ∓ 1)/(sinh 2x ± 2x), where 1 − ν = 2(1 − c_s²/c_p²) in
/// the plane of the wave.
template <typename Real>
Real slow(const ClosedForm<Real>& its, Kind kind, const Real& k) {
  const Real x = 2 * k * its.half, up = exp(x), down = 1 / up;
  const Real cosh = (up + down) / 2, sinh = (up - down) / 2;
  const Real ratio = its.shear_square() / (its.pressure_speed * its.pressure_speed);
  const Real factor = 1 / (2 * its.shear_modulus * k * (1 - ratio));
  return kind == Kind::symmetric ? Real(factor * (cosh - 1) / (sinh + x)) : Real(factor * (cosh + 1) / (sinh - x));
}

/// Σ φ²/ω⁴ of all modes: the slope of the response at z = 0.
inline Exact slow_moment(const ClosedForm<Exact>& its, Kind kind, double k) {
  const Exact wave = k, slowest = kind == Kind::symmetric ? Exact(1) : Exact(wave * wave * wave * wave);
  const Exact step = slowest * Exact("1e-30");
  const auto at = [&](const Exact& z) {
    const auto fraction = rayleigh_lamb<Exact>(its, kind, wave, z);
    return Exact(fraction.numerator / fraction.denominator);
  };
  return (at(step) - at(-step)) / (2 * step);
}

/// A mode in closed form.
struct ExactMode {
  Exact omega;
  Exact strength;  ///< φ², the residue of the response
};

/// The root of D next to a frequency, by Newton's method, and the residue −N/D′ there.
inline ExactMode exact_mode(const ClosedForm<Exact>& its, Kind kind, double k, double near) {
  const Exact wave = k, unit = Exact("1e-30");
  Exact z = Exact(near) * near, slope = 0;
  const auto at = [&](const Exact& here) { return rayleigh_lamb<Exact>(its, kind, wave, here); };
  for (int n = 0; n < 3; ++n) {
    const Exact step = unit * z;
    slope = (at(z + step).denominator - at(z - step).denominator) / (2 * step);
    z -= at(z).denominator / slope;
  }
  return {sqrt(z), -at(z).numerator / slope};
}

/// Number of roots of D below a frequency, from its signs at many frequencies, more of them where bending is slow.
inline int count_of_signs(const ClosedForm<double>& its, Kind kind, double k, double omega, int samples) {
  const double slowest = 0.1 * k * std::min(1.0, k * its.half) * std::sqrt(its.shear_square());
  int roots = 0;
  double last = 0.0;
  for (int i = 0; i <= samples; ++i) {
    const double share = static_cast<double>(i) / samples, at = slowest + (omega - slowest) * share * share;
    const double here = rayleigh_lamb(its, kind, k, at * at).denominator;
    if (here * last < 0.0) ++roots;
    last = here;
  }
  return roots;
}

}  // namespace stoss::test
