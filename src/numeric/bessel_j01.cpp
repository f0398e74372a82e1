#include "numeric/bessel_j01.hpp"

#include <array>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

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

BesselJ01 far_values(double x) {
  const double sine = std::sin(x), cosine = std::cos(x), scale = 1.0 / std::sqrt(std::numbers::pi * x);
  return {scale * far_value(zeroth, x, cosine + sine, sine - cosine),
          scale * far_value(first, x, sine - cosine, -(sine + cosine))};
}

/// Taylor polynomials of J_0 about the middles of short intervals, good to rounding: some ten operations a value, where
/// a rational approximation and Hankel's expansion take two hundred.
class BesselTable {
 public:
  static constexpr double end = 128.0;  ///< arguments below it

  BesselTable() {
    for (std::size_t i = 0; i < polynomials_.size(); ++i) polynomials_[i] = about(static_cast<double>(i) / per_unit);
  }

  [[nodiscard]] double zeroth(double x) const {
    const auto [polynomial, shift] = at(x);
    double value = 0.0;
    for (std::size_t k = polynomial.size(); k-- > 0;) value = value * shift + polynomial[k];
    return value;
  }

  /// −J_0'.
  [[nodiscard]] double first(double x) const {
    const auto [polynomial, shift] = at(x);
    double slope = 0.0;
    for (std::size_t k = polynomial.size(); k-- > 1;) slope = slope * shift + static_cast<double>(k) * polynomial[k];
    return -slope;
  }

 private:
  static constexpr double per_unit = 8.0;
  using Polynomial = std::array<double, 10>;  // the next term of the slope is below 10⁻¹⁶
  struct Place {
    const Polynomial& polynomial;
    double shift;
  };

  [[nodiscard]] Place at(double x) const {
    const auto index = static_cast<std::size_t>(per_unit * x + 0.5);
    return {polynomials_[index], x - static_cast<double>(index) / per_unit};
  }

  /// From c (k+1)(k+2) a_{k+2} = −(k+1)² a_{k+1} − c a_k − a_{k−1}, Bessel's equation about c; at 0 from the series.
  static Polynomial about(double center) {
    Polynomial a{};
    if (center == 0.0) {
      a[0] = 1.0;
      for (std::size_t k = 2; k < a.size(); k += 2) a[k] = -a[k - 2] / static_cast<double>(k * k);
      return a;
    }
    const BesselJ01 exact = center < far ? BesselJ01{boost::math::cyl_bessel_j(0, center, in_double),
                                                     boost::math::cyl_bessel_j(1, center, in_double)}
                                         : far_values(center);
    a[0] = exact.zeroth;
    a[1] = -exact.first;
    for (std::size_t k = 0; k + 2 < a.size(); ++k) {
      const auto n = static_cast<double>(k + 1);
      const double before = k > 0 ? a[k - 1] : 0.0;
      a[k + 2] = -(n * n * a[k + 1] + center * a[k] + before) / (center * n * (n + 1.0));
    }
    return a;
  }

  std::vector<Polynomial> polynomials_{static_cast<std::size_t>(end * per_unit) + 1};
};

/// Made when it is first needed, in a tenth of a millisecond.
const BesselTable& bessel_table() {
  static const BesselTable table;
  return table;
}

}  // namespace

BesselJ01 bessel_j01(double x) {
  if (!(x < BesselTable::end)) return far_values(x);
  const BesselTable& table = bessel_table();
  return {table.zeroth(x), table.first(x)};
}

double bessel_j0(double x) { return x < BesselTable::end ? bessel_table().zeroth(x) : far_values(x).zeroth; }

}  // namespace stoss::numeric
