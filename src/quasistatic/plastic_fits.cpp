#include "quasistatic/plastic_fits.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace stoss::quasistatic::fits {
namespace {

/// ln of a quantity over that at the onset, Σ b_k (ln d)^k from k = `first` on.
template <std::size_t Terms>
struct Fit {
  int first;
  std::array<double, Terms> terms;

  [[nodiscard]] double value(double x) const {
    double sum = 0.0;
    for (std::size_t i = Terms; i-- > 0;) sum = sum * x + terms[i];
    return sum * std::pow(x, first);
  }

  [[nodiscard]] double slope(double x) const {
    double sum = 0.0;
    for (std::size_t i = Terms; i-- > 0;) sum = sum * x + (first + static_cast<int>(i)) * terms[i];
    return sum * std::pow(x, first - 1);
  }

  /// With the tangent beyond the last run.
  [[nodiscard]] double at(double x) const {
    const double last = std::min(x, end());
    return value(last) + slope(last) * (x - last);
  }
  [[nodiscard]] double slope_at(double x) const { return slope(std::min(x, end())); }

  static double end() {
    static const double last = std::log(1600.0);
    return last;
  }
};

// Of f/d^(3/2), a²/d, (d_m − d_r)/d_m, and the work of the return over that of the compression.
constexpr Fit<7> hardness{
    2, {-3.457802e-02, -1.626393e-02, 1.170131e-02, -3.905304e-03, 7.065046e-04, -6.556353e-05, 2.436239e-06}};
constexpr Fit<7> area{
    2, {1.061446e-01, -5.140971e-02, 2.332555e-02, -7.764317e-03, 1.475124e-03, -1.415663e-04, 5.343506e-06}};
constexpr Fit<6> way{2, {-2.167939e-01, 1.041719e-01, -3.266291e-02, 5.939998e-03, -5.658455e-04, 2.167279e-05}};
constexpr Fit<6> regained{2, {-1.858069e-01, 6.987411e-02, -1.852472e-02, 3.069021e-03, -2.815691e-04, 1.072938e-05}};

}  // namespace

double force(double depth) { return depth * std::sqrt(depth) * std::exp(hardness.at(std::log(depth))); }

double stiffness(double depth) { return force(depth) / depth * (1.5 + hardness.slope_at(std::log(depth))); }

double radius(double depth) { return std::sqrt(depth * std::exp(area.at(std::log(depth)))); }

double work(double depth) {
  using Rule = boost::math::quadrature::gauss<double, 20>;
  const double x = std::log(depth), last = std::min(x, hardness.end());
  const auto integrand = [](double at) { return force(std::exp(at)) * std::exp(at); };
  double sum = 0.4;
  constexpr int panels = 4;
  for (int i = 0; i < panels; ++i) sum += Rule::integrate(integrand, last * i / panels, last * (i + 1) / panels);
  if (x == last) return sum;
  const double power = 2.5 + hardness.slope_at(last);  // of f d beyond
  return sum + integrand(last) * std::expm1(power * (x - last)) / power;
}

Unloading unloading(double deepest) {
  const double x = std::log(deepest), recovers = deepest * std::exp(way.at(x)), most = force(deepest);
  const double back = work(deepest) * std::exp(regained.at(x));
  return {deepest - recovers, most * recovers / back - 1.0, most * most / (recovers * recovers * recovers)};
}

}  // namespace stoss::quasistatic::fits
