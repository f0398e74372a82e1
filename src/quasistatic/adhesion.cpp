// With κ² = 2πw/(E*R) and a/R = κ^{2/3} s² the equations of Johnson, Kendall and Roberts have no constants left.
#include "stoss/quasistatic/adhesion.hpp"

#include <cmath>
#include <numbers>

#include "check.hpp"

namespace stoss::quasistatic {
namespace {

using std::numbers::pi;
constexpr double most_number = 1e100;

void require_work(double work) {
  require("work_of_adhesion", work, {0.0, most_number, true, true, "0 to 1e100"}, "in E R; of two surfaces, w");
}

void require_mass(double mass) {
  require("mass", mass, {1.0 / most_number, most_number, true, true, "1e-100 to 1e100"}, "reduced mass in rho R^3");
}

}  // namespace

double adhesion_energy(const PointPair& pair, double work_of_adhesion) {
  (void)point_hertz(pair, 0.0);  // refuses what is out of range
  require_work(work_of_adhesion);
  const double s = std::cbrt(0.25);
  const double number = 0.3 + 0.5 * std::pow(s, 4) + 8.0 / 15.0 * std::pow(s, 10) - 4.0 / 3.0 * std::pow(s, 7);
  const double work = 2.0 * pi * work_of_adhesion;  // of E*R³κ^{10/3}, κ² = 2πw/(E*R)
  return number * work * std::cbrt(work * work * pair.softness * pair.softness) * std::pow(pair.curvature, -4.0 / 3.0);
}

double sticking_speed(const PointPair& pair, double work_of_adhesion, double mass) {
  require_mass(mass);
  return std::sqrt(2.0 / mass * adhesion_energy(pair, work_of_adhesion));
}

}  // namespace stoss::quasistatic
