#include "numeric/bessel.hpp"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace stoss::numeric {

namespace {

/// By how much the order of the kind exceeds n twice.
double twice_excess(BesselKind kind) { return kind == BesselKind::spherical ? 1.0 : 0.0; }

/// Factor that normalises spherical functions that are known up to it.
double spherical_scale(double x, double zeroth, double first) {
  const double j0 = std::sin(x) / x;
  const double j1 = (j0 - std::cos(x)) / x;
  return std::abs(zeroth) > std::abs(first) ? j0 / zeroth : j1 / first;
}

}  // namespace

void bessel_pairs(double x, std::vector<BesselPair>& pairs, BesselKind kind) {
  constexpr int chunk = 200;
  const double big = std::ldexp(1.0, chunk);
  const double small = std::ldexp(1.0, -chunk);

  // Above x + 12 x^{1/3} the wanted solution decays so fast that the start value is forgotten.
  const int top = static_cast<int>(pairs.size()) - 1;
  const double width = std::cbrt(x);
  const int turning = static_cast<int>(std::ceil(x + 12.0 * width));
  const int start = std::max(top + 1, turning) + static_cast<int>(5.0 * width) + 16;

  const double excess = twice_excess(kind);
  double above = 0.0;
  double here = small;
  int exponent = 0;  // of `above` and `here`, common
  double sum = 0.0;  // J_0 + 2 Σ J_{2k}, same exponent
  double zeroth = 0.0, first = 0.0;
  for (int n = start; n >= 0; --n) {
    // here ∝ J_n, above ∝ J_{n+1}
    const double below = n > 0 ? (2.0 * n + excess) / x * here - above : -above;
    if (n <= top) {
      pairs[static_cast<std::size_t>(n)] = {here, x * above, exponent};
    }
    if (n == 0) {
      zeroth = here;
      first = above;
    }
    if (n % 2 == 0) sum += n > 0 ? 2.0 * here : here;
    above = here;
    here = below;
    if (std::abs(here) > big) {
      here *= small;
      above *= small;
      sum *= small;
      exponent += chunk;
    }
  }
  const double scale = kind == BesselKind::spherical ? spherical_scale(x, zeroth, first) : 1.0 / sum;
  for (auto& pair : pairs) {
    pair.value *= scale;
    pair.next *= scale;
    pair.exponent -= exponent;
  }
}

BesselPair last_pair(double x, std::vector<BesselPair>& pairs, BesselKind kind) {
  bessel_pairs(x, pairs, kind);
  const BesselPair& pair = pairs.back();
  const int shift = std::ilogb(std::hypot(pair.value, pair.next));
  return {std::ldexp(pair.value, -shift), std::ldexp(pair.next, -shift), pair.exponent + shift};
}

BesselTaylor::BesselTaylor(int order, double center, const BesselPair& pair, double reach, BesselKind kind)
    : center_(center), exponent_(pair.exponent) {
  // With x = c + h, J_n = Σ a_k h^k and J_{n+1} = Σ b_k h^k, from x J_n' = n J_n − x J_{n+1} and
  // x J_{n+1}' = x J_n − (n+1) J_{n+1}:
  //   c (k+1) a_{k+1} = (n−k) a_k − c b_k − b_{k−1},   c (k+1) b_{k+1} = c a_k + a_{k−1} − (n+1+k) b_k.
  // For the spherical ones n + 2 stands for n + 1. The loop works with a_k reach^k, which cannot overflow.
  const double step = reach / center;
  const double after = order + 1 + twice_excess(kind);
  auto& c = coefficient_;
  c[0] = {pair.value, pair.next / center};
  const double amplitude = std::abs(c[0].here) + std::abs(c[0].next);
  Coefficient before{0.0, 0.0};
  for (int k = 0; k < max_degree; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double factor = step / (k + 1);
    c[i + 1].here = factor * ((order - k) * c[i].here - center * c[i].next - reach * before.next);
    c[i + 1].next = factor * (center * c[i].here + reach * before.here - (after + k) * c[i].next);
    before = c[i];
    if (std::abs(c[i + 1].here) + std::abs(c[i + 1].next) < 1e-18 * amplitude) {
      degree_ = k + 1;
      break;
    }
  }
  double power = 1.0;
  for (int k = 0; k <= degree_; ++k) {
    auto& [here, next] = c[static_cast<std::size_t>(k)];
    here *= power;
    next *= power;
    power /= reach;
  }
}

BesselPair BesselTaylor::operator()(double shift) const {
  double value = 0.0;
  double next = 0.0;
  for (int k = degree_; k >= 0; --k) {
    const auto& c = coefficient_[static_cast<std::size_t>(k)];
    value = value * shift + c.here;
    next = next * shift + c.next;
  }
  return {value, (center_ + shift) * next, exponent_};
}

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
    // Half-way between two places, either will do.
    const auto index = static_cast<std::size_t>(per_unit * x + 0.5);  // NOLINT(bugprone-incorrect-roundings)
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
