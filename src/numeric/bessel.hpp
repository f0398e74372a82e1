#pragma once

#include <array>
#include <vector>

namespace stoss::numeric {

/// J_n of the disk, or the spherical j_n = √(π/2x) J_{n+½} of the sphere.
enum class BesselKind { cylindrical, spherical };

/// Two neighbouring Bessel functions, (J_n(x), x J_{n+1}(x)) = (value, next) · 2^exponent.
/// The slope is x J_n' = n J_n − x J_{n+1}, of either kind: keeping `next` instead of the slope avoids the cancellation
/// of the two where n ≫ x. The common power of two keeps orders n ≫ x representable, where J_n itself underflows.
struct BesselPair {
  double value = 0.0;
  double next = 0.0;
  int exponent = 0;
};

/// Slope x J_n'(x), in units of 2^exponent.
inline double slope(int order, const BesselPair& pair) { return order * pair.value - pair.next; }

/// Fills pairs[n] for n = 0 … pairs.size()−1 at the argument x > 0 by one backward (Miller) sweep of
/// J_{n−1} = (2n/x) J_n − J_{n+1}, normalised with J_0 + 2 Σ J_{2k} = 1 (DLMF 3.6(vi), 10.12.4); for the spherical ones
/// with 2n + 1 for 2n, and the greater of j_0 = sin x/x and j_1 (DLMF 10.51.1, 10.49.3).
void bessel_pairs(double x, std::vector<BesselPair>& pairs, BesselKind kind = BesselKind::cylindrical);

/// The pair of the last order of `pairs`, which it fills, scaled to about 1.
[[nodiscard]] BesselPair last_pair(double x, std::vector<BesselPair>& pairs, BesselKind kind = BesselKind::cylindrical);

/// Taylor polynomials of (J_n, x J_{n+1}) about an argument at which the pair is known: they continue a grid value to
/// nearby arguments for a few nanoseconds. Scaled as the pair that they continue.
class BesselTaylor {
 public:
  /// Coefficients about `center`, good to rounding for 0 ≤ x − center ≤ reach, as long as order · reach ≤ center.
  BesselTaylor(int order, double center, const BesselPair& pair, double reach,
               BesselKind kind = BesselKind::cylindrical);

  /// The pair at center + shift; the exponent is that of the pair given to the constructor.
  [[nodiscard]] BesselPair operator()(double shift) const;

 private:
  static constexpr int max_degree = 47;
  struct Coefficient {
    double here, next;  // of J_n and J_{n+1}
  };
  std::array<Coefficient, max_degree + 1> coefficient_{};
  double center_;
  int degree_ = max_degree;
  int exponent_;
};

/// J_0 and J_1 at one argument.
struct BesselJ01 {
  double zeroth, first;
};

/// J_0(x) and J_1(x) for x ≥ 0; absolute error below 3e-15.
[[nodiscard]] BesselJ01 bessel_j01(double x);

/// J_0(x) alone.
[[nodiscard]] double bessel_j0(double x);

}  // namespace stoss::numeric
