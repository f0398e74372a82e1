#include "numeric/bessel.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

}  // namespace stoss::numeric
