#include "numeric/bessel_j01.hpp"

#include <array>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace stoss::numeric {
namespace {

constexpr boost::math::policies::policy<boost::math::policies::promote_double<false>> in_double{};

/// From here on Hankel's expansion is good to rounding.
constexpr double far = 25.0;

/// P = Σ even/x^2k and Q = Σ odd/x^(2k+1) of Hankel's expansion (DLMF 10.17.3), J_n = √(2/πx) (P cos χ − Q sin χ), χ =
/// x − (2n + 1)π/4.
struct Hankel {
  std::array<double, 9> even{}, odd{};

  constexpr explicit Hankel(int order) {
    double term = 1.0;  // a_k with the sign of its place in P or Q
    for (std::size_t k = 0; k < 2 * even.size(); ++k) {
      (k % 2 == 0 ? even : odd)[k / 2] = k / 2 % 2 == 0 ? term : -term;
      const double next = 2.0 * static_cast<double>(k) + 1.0;
      term *= (4.0 * order * order - next * next) / (8.0 * (static_cast<double>(k) + 1.0));
    }
  }
};

constexpr Hankel zeroth(0), first(1);

double sum(const std::array<double, 9>& coefficients, double x) {
  double value = 0.0;
  for (std::size_t k = coefficients.size(); k-- > 0;) value = value * x + coefficients[k];
  return value;
}

/// √(πx) J_n by √2 cos χ and √2 sin χ.
double far_value(const Hankel& expansion, double x, double cosine, double sine) {
  const double inverse = 1.0 / (x * x);
  return sum(expansion.even, inverse) * cosine - sum(expansion.odd, inverse) / x * sine;
}

}  // namespace

BesselJ01 bessel_j01(double x) {
  if (x < far) return {bessel_j0(x), boost::math::cyl_bessel_j(1, x, in_double)};
  const double sine = std::sin(x), cosine = std::cos(x), scale = 1.0 / std::sqrt(std::numbers::pi * x);
  return {scale * far_value(zeroth, x, cosine + sine, sine - cosine),
          scale * far_value(first, x, sine - cosine, -(sine + cosine))};
}

double bessel_j0(double x) {
  if (x < far) return boost::math::cyl_bessel_j(0, x, in_double);
  const double sine = std::sin(x), cosine = std::cos(x);
  return 1.0 / std::sqrt(std::numbers::pi * x) * far_value(zeroth, x, cosine + sine, sine - cosine);
}

}  // namespace stoss::numeric
