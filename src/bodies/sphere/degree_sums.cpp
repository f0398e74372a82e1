#include "bodies/sphere/degree_sums.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/sphere/along/toroidal.hpp"
#include "bodies/sphere/legendre.hpp"
#include "bodies/sphere/surface_points.hpp"
#include "numeric/cosine_integral.hpp"
#include "numeric/dense.hpp"
#include "numeric/quadrature.hpp"

namespace stoss::bodies::sphere {
namespace {

using Matrix = numeric::SymmetricProducts::Matrix;

constexpr int rule_nodes = 24;       // of the quadrature of a sum
constexpr double rule_phase = 18.0;  // by which its terms may turn to either side of the middle
constexpr long lowest_start = 64;    // of the quadrature: the expansion of P_ν needs a high degree

/// Coefficients between the two shapes P_{n+1} and P_{n−1} of a degree, and along y that of P_n.
struct Pair {
  double upper = 0.0, mixed = 0.0, lower = 0.0, middle = 0.0;

  Pair(double n, const Flexibility& r, double weight) {
    const double up = (n + 1.0) / (2.0 * n + 1.0), down = n / (2.0 * n + 1.0);
    upper = weight * up * up * (r.radial - 2.0 * n * r.mixed + n * n * r.tangential);
    mixed = weight * up * down * (r.radial + r.mixed - n * (n + 1.0) * r.tangential);
    lower = weight * down * down * (r.radial + 2.0 * (n + 1.0) * r.mixed + (n + 1.0) * (n + 1.0) * r.tangential);
  }

  /// Turns it into that along y, for n ≥ 1.
  void turn(double n, double toroidal, double weight) {
    const AlongShare share = along_share(n);
    upper *= share.upper * share.upper;
    mixed *= share.upper * share.lower;
    lower *= share.lower * share.lower;
    middle = weight * 0.5 * n * (n + 1.0) * toroidal;
  }
};

/// Σ (upper x xᵀ + mixed (x yᵀ + y xᵀ) + lower y yᵀ + middle z zᵀ) over rows x = P_{n+1}, y = P_{n−1} and z = P_n.
class ShapeProducts {
 public:
  ShapeProducts(Eigen::Index rings, const Poll& poll) : products_(static_cast<std::size_t>(rings), poll) {}

  void add(const Pair& pair, const Eigen::ArrayXd& upper, const Eigen::ArrayXd& lower) {
    products_.start();
    products_.shape() = upper.matrix().transpose();
    products_.load() = (pair.upper * upper + pair.mixed * lower).matrix().transpose();
    products_.start();
    products_.shape() = lower.matrix().transpose();
    products_.load() = (pair.mixed * upper + pair.lower * lower).matrix().transpose();
  }

  void add(double middle, const Eigen::ArrayXd& row) {
    products_.start();
    products_.shape() = row.matrix().transpose();
    products_.load() = (middle * row).matrix().transpose();
  }

  [[nodiscard]] Matrix sum() { return products_.sum(); }

 private:
  numeric::SymmetricProducts products_;
};

Flexibility coefficient(const DegreeSum& sum, long n) {
  Flexibility r;
  if (sum.with_static) r = static_flexibility(sum.poisson, static_cast<int>(n));
  if (static_cast<std::size_t>(n) < sum.coefficients.size()) {
    const Flexibility& given = sum.coefficients[static_cast<std::size_t>(n)];
    r.radial += given.radial;
    r.mixed += given.mixed;
    r.tangential += given.tangential;
  }
  return r;
}

double toroidal_coefficient(const DegreeSum& sum, long n) {
  double r = sum.with_static ? toroidal_flexibility(sum.poisson, static_cast<double>(n)) : 0.0;
  if (static_cast<std::size_t>(n) < sum.toroidal.size()) r += sum.toroidal[static_cast<std::size_t>(n)];
  return r;
}

Eigen::ArrayXd joined(const Eigen::ArrayXd& axial, const Eigen::ArrayXd& outward) {
  Eigen::ArrayXd both(axial.size() + outward.size());
  both << axial, outward;
  return both;
}

/// P¹_n = sin θ P_n′ of a real degree n.
Eigen::ArrayXd associated(const LegendreOfRealDegree& legendre, const Eigen::ArrayXd& sine, double n) {
  return n * (n + 1.0) / (2.0 * n + 1.0) * (legendre(n - 1.0) - legendre(n + 1.0)) / sine;
}

/// The degrees 0 … last one by one; that of Nyquist with weight ½.
void add_degrees(const DegreeSum& sum, const Eigen::ArrayXd& angle, long last, long nyquist, ShapeProducts& products) {
  LegendreSequence sequence(angle);
  const Eigen::ArrayXd sine = angle.sin();
  Eigen::ArrayXd below = Eigen::ArrayXd::Zero(angle.size()), here = sequence.value();
  Eigen::ArrayXd slope_below = below, slope = below;
  for (long n = 0; n <= last; ++n) {
    sequence.advance();
    const auto degree = static_cast<double>(n);
    const double weight = n == nyquist ? 0.5 : 1.0;
    Pair pair(degree, coefficient(sum, n), weight);
    if (sum.outward) {
      products.add(pair, joined(sequence.value(), sine * sequence.slope() / (degree + 1.0)),
                   joined(below, -sine * slope_below / std::max(degree, 1.0)));
      slope_below = slope;
      slope = sequence.slope();
    } else if (!sum.along) {
      products.add(pair, sequence.value(), below);
    } else if (n > 0) {
      pair.turn(degree, toroidal_coefficient(sum, n), weight);
      products.add(pair, sequence.value(), below);
      products.add(pair.middle, here);
    }
    below = here;
    here = sequence.value();
  }
}

/// The static flexibilities of the degrees first … nyquist by quadrature.
void add_blocks(const DegreeSum& sum, const Eigen::ArrayXd& angle, long first, long nyquist, ShapeProducts& products) {
  const LegendreOfRealDegree legendre(angle);
  const Eigen::ArrayXd sine = angle.sin();
  const auto add = [&](double n, double weight) {
    Pair pair(n, flexibility_of_degree(sum.poisson, n), weight);
    if (sum.outward) {
      products.add(pair, joined(legendre(n + 1.0), associated(legendre, sine, n + 1.0) / (n + 1.0)),
                   joined(legendre(n - 1.0), -associated(legendre, sine, n - 1.0) / n));
      return;
    }
    if (sum.along) {
      pair.turn(n, toroidal_flexibility(sum.poisson, n), weight);
      products.add(pair.middle, legendre(n));
    }
    products.add(pair, legendre(n + 1.0), legendre(n - 1.0));
  };
  const auto most = static_cast<long>(std::min(rule_phase / angle.maxCoeff(), 1e9));
  numeric::SumRule rule;
  long terms = 0;
  while (first <= nyquist) {
    const long wanted = std::min({most, 2 * first, nyquist - first + 1});
    if (wanted != terms) rule = numeric::sum_rule(wanted, rule_nodes);
    terms = wanted;
    for (std::size_t k = 0; k < rule.node.size(); ++k) add(static_cast<double>(first) + rule.node[k], rule.weight[k]);
    first += terms;
  }
  add(static_cast<double>(nyquist), -0.5);
}

/// On the circle of a smaller partner, rings lie closer to each other on this sphere the further out they are, and a
/// sum to one degree N for all leaves too little of the shortest waves there: W would not stay positive definite. Each
/// pair of rings has the degrees that its own distance resolves instead. High degrees add C cos nΔθ/n, C =
/// 4D/(3π√(sin θ_i sin θ_j)) with D the softness, so the change is C [Ci(π|i−j|) − Ci(NΔθ)]; outward the same of each
/// direction by itself.
void resolve_each_pair(double softness, const ContactPoints& points, const Eigen::ArrayXd& angle, double nyquist,
                       Matrix& lower) {
  const double strength = 4.0 * softness / (3.0 * std::numbers::pi);
  std::vector<double> wanted{0.0};
  for (std::size_t k = 1; k < points.count; ++k) {
    wanted.push_back(numeric::cosine_integral(std::numbers::pi * static_cast<double>(k)));
  }
  for (Eigen::Index i = 0; i < angle.size(); ++i) {
    const double stretch = points.radius * std::cos(points.angle(static_cast<std::size_t>(i))) / std::cos(angle(i));
    for (Eigen::Index k = 0; k < lower.rows(); k += angle.size()) {
      lower(k + i, k + i) -=
          strength / std::sin(angle(i)) * std::log(nyquist * points.spacing * stretch / std::numbers::pi);
    }
    for (Eigen::Index j = 0; j < i; ++j) {
      const double change =
          wanted[static_cast<std::size_t>(i - j)] - numeric::cosine_integral(nyquist * (angle(i) - angle(j)));
      for (Eigen::Index k = 0; k < lower.rows(); k += angle.size()) {
        lower(k + i, k + j) += strength / std::sqrt(std::sin(angle(i)) * std::sin(angle(j))) * change;
      }
    }
  }
}

Eigen::ArrayXd ring_angles(const ContactPoints& points) {
  Eigen::ArrayXd angle(static_cast<Eigen::Index>(points.count));
  for (std::size_t i = 0; i < points.count; ++i) angle(static_cast<Eigen::Index>(i)) = ring_angle(points, i);
  return angle;
}

}  // namespace

// b = sin θ dP_n/dθ = −sin² θ P_n′(cos θ)
ResidualShape::Loads::Loads(const ContactPoints& points)
    : cosine_(ring_angles(points).cos()), square_(ring_angles(points).sin().square()), sequence_(ring_angles(points)) {}

std::vector<double> sum_over_degrees(const DegreeSum& sum, const ContactPoints& points, const Poll& poll) {
  const auto rings = static_cast<Eigen::Index>(points.count);
  if (rings == 0) return {};
  const Eigen::ArrayXd angle = ring_angles(points);
  const auto nyquist = std::lround(std::numbers::pi / (points.spacing * points.radius));
  const auto given = static_cast<long>(sum.coefficients.size());
  const Eigen::Index values = (sum.outward ? 2 : 1) * rings;
  ShapeProducts products(values, poll);
  // A term of the quadrature costs as much as some ten degrees one by one.
  const long start = std::max({lowest_start, given, static_cast<long>(2000.0 * angle.maxCoeff())});
  if (!sum.with_static) {
    add_degrees(sum, angle, std::min(given - 1, nyquist), nyquist, products);
  } else if (nyquist < start + 32 * rings || angle.maxCoeff() > 0.1) {
    add_degrees(sum, angle, nyquist, nyquist, products);
  } else {
    add_degrees(sum, angle, start - 1, nyquist, products);
    add_blocks(sum, angle, start, nyquist, products);
  }
  Matrix half = products.sum();
  if (sum.with_static && points.radius != 1.0) {
    const double softness = sum.along ? softness_along(sum.poisson) : 1.0 - sum.poisson * sum.poisson;
    resolve_each_pair(softness, points, angle, static_cast<double>(nyquist), half);
  }
  std::vector<double> result(static_cast<std::size_t>(values * values));
  Eigen::Map<Matrix> matrix(result.data(), values, values);
  matrix = half.triangularView<Eigen::Lower>();
  matrix.triangularView<Eigen::StrictlyUpper>() = half.transpose();
  matrix /= ResidualShape::mass;
  return result;
}

}  // namespace stoss::bodies::sphere
