// Differences of large terms are removed with m² n² = x² y² and m² − n² = a² + x² − y²:
//
//   m² − x² = a² m²/(m² + y²),   −σ_yy = ½ (m − x) [m (m − x) + 2n²]/(m² + n²).
#include "stoss/quasistatic/hertz.hpp"

#include <cmath>
#include <limits>

#include "check.hpp"

namespace stoss::quasistatic {
namespace {

constexpr double largest = std::numeric_limits<double>::max();

void require_place(double y) {
  require("y", y, {-largest, largest, true, true, "any finite number"}, "position along the wall in R");
}

}  // namespace

double hertz_half_width(double force) {
  require("force", force, {0.0, max_hertz_force, true, true, "0 to 0.25"},
          "in units of pi R E; Hertz' contact is small");
  return 2.0 * std::sqrt(force);
}

double hertz_pressure(double force, double y) {
  const double a = hertz_half_width(force);
  require_place(y);
  return std::abs(y) < a ? 0.5 * std::sqrt((a - y) * (a + y)) : 0.0;
}

PlaneStress hertz_stress(double force, double depth, double y) {
  const double a = hertz_half_width(force);
  require("depth", depth, {0.0, largest, true, true, "0 or more"}, "below the surface of the half-plane, in R");
  require_place(y);
  if (a == 0.0) return {};
  // In units of a, in which the middle of the contact and its ends are at 0 and ±1.
  const double x = depth / a, s = std::abs(y / a);
  const double inside = (a - std::abs(y)) / a;
  const double h = std::hypot(x, s + 1.0) * std::hypot(x, inside);  // m² + n²
  if (h == 0.0) return {};                                          // the end of the contact
  const double difference = x * x + inside * (1.0 + s);             // m² − n²
  double m, n;
  if (difference >= 0.0) {
    m = std::sqrt(0.5 * (h + difference));
    n = x * s / m;
  } else {
    n = std::sqrt(0.5 * (h - difference));
    m = x * s / n;
  }
  const double reach = std::hypot(m, s);
  const double share = m / reach * (m / reach);  // m² − x²
  const double trace = share / (m + x);          // m − x
  const double scale = -0.5 * a;
  PlaneStress stress;
  if (m == 0.0) return stress;  // the free surface
  stress.xx = scale * m * share / h;
  stress.yy = scale * trace * (m * trace + 2.0 * n * n) / h;
  stress.xy = std::copysign(scale * n * share / h, -y);
  return stress;
}

}  // namespace stoss::quasistatic
