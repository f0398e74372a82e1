// Maugis' equations with A = a (4E*/3πwR²)^{1/3}, F/πwR and m = c/a, where the pull reaches to the radius c:
//   (λA²/2)(s + (m² − 2) q) + (4λ²A/3)(s q − m + 1) = 1,  F = A³ − λA²(s + m² q),  s = √(m² − 1), q = arcsec m.
#include "published.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stoss/quasistatic/adhesion.hpp"

namespace adhesion_study {
namespace {

double force_of(double number, double a, double m) {
  const double s = std::sqrt(m * m - 1.0), q = std::acos(1.0 / m);
  return a * a * a - number * a * a * (s + m * m * q);
}

double rest_of(double number, double a, double m) {
  const double s = std::sqrt(m * m - 1.0), q = std::acos(1.0 / m);
  return 0.5 * number * a * a * (s + (m * m - 2.0) * q) + 4.0 / 3.0 * number * number * a * (s * q - m + 1.0) - 1.0;
}

}  // namespace

double jkr_work() { return stoss::quasistatic::adhesion_energy({.curvature = 1.0, .softness = 1.0}, 1.0); }

double maugis_pull_off(double number) {
  double least = 0.0;
  for (int i = 1; i <= 4000; ++i) {
    const double a = 1e-3 * i;
    double low = 1.0, high = 2.0;
    while (rest_of(number, a, high) < 0.0) high *= 2.0;
    for (int k = 0; k < 100; ++k) {
      const double m = 0.5 * (low + high);
      (rest_of(number, a, m) < 0.0 ? low : high) = m;
    }
    least = std::min(least, force_of(number, a, low));
  }
  return -least * std::numbers::pi;
}

}  // namespace adhesion_study
