// A ball of alumina on glass, as measured by Kharaz, Gorham and Salman, with nothing fitted.
#include <fmt/os.h>

#include <cmath>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "study.hpp"

namespace study {

namespace {

constexpr double degree = M_PI / 180.0;

// SI. Moduli and densities as usual for these materials; radius, speed and friction are those of the experiment.
constexpr double ball_young = 380e9, ball_poisson = 0.23, ball_density = 4000.0, radius = 2.5e-3;
constexpr double glass_young = 70e9, glass_poisson = 0.25, glass_density = 2500.0;
constexpr double speed_in_si = 3.9, friction = 0.092;

double shear(double young, double poisson) { return 0.5 * young / (1.0 + poisson); }

/// κ = Σ (1 − ν)/G over Σ (1 − ν/2)/G, and Dundurs' β.
double kappa_of_pair() {
  const double ball = shear(ball_young, ball_poisson), glass = shear(glass_young, glass_poisson);
  return ((1.0 - ball_poisson) / ball + (1.0 - glass_poisson) / glass) /
         ((1.0 - 0.5 * ball_poisson) / ball + (1.0 - 0.5 * glass_poisson) / glass);
}

double beta_of_pair() {
  const double ball = shear(ball_young, ball_poisson), glass = shear(glass_young, glass_poisson);
  return 0.5 * (ball * (1.0 - 2.0 * glass_poisson) - glass * (1.0 - 2.0 * ball_poisson)) /
         (ball * (1.0 - glass_poisson) + glass * (1.0 - ball_poisson));
}

/// What coupling adds to ε_t of a disk with this β and friction.
double coupling(double x) {
  const double poisson = 1.0 - 2.0 * beta_of_pair(), speed = 0.003;
  static const stoss::RefinableContact wall = disk_at_wall(poisson), pair = equal_disks(poisson);
  return rules(wall, speed, friction, {x}, 1e-2).front().tangential_restitution.value -
         rules(pair, 2.0 * speed, friction, {x}, 1e-2).front().tangential_restitution.value;
}

}  // namespace

void write_glass(const std::string& name) {
  const double c = std::sqrt(ball_young / ball_density);
  const stoss::RefinableContact contact(
      stoss::sphere(stoss::Sphere{.poisson = ball_poisson}),
      stoss::half_space(stoss::HalfSpace{
          .poisson = glass_poisson, .young = glass_young / ball_young, .density = glass_density / ball_density}));
  auto out = fmt::output_file(name);
  out.print(
      "# A ball of alumina on glass at {} m/s, friction {}; kappa = {:.5f}, beta = {:.5f}; made by `make results`.\n",
      speed_in_si, friction, kappa_of_pair(), beta_of_pair());
  out.print(
      "angle[deg],x,restitution,tangential_restitution,tangential_restitution_error,maw,added_by_coupling_of_disks,"
      "neglected_coupling,tangential_of_center,spin[rad/s],angle_of_patch[deg],converged\n");
  std::vector<double> angles{0.5};
  for (int i = 1; i <= 88; ++i) angles.push_back(i);
  for (const double angle : angles) {
    const double normal = speed_in_si / c * std::cos(angle * degree),
                 along = speed_in_si / c * std::sin(angle * degree);
    const stoss::ObliqueRestitution r = stoss::oblique_restitution(
        contact, normal, stoss::Obliquity{.tangential = along, .friction = friction}, {.tolerance = 1e-3});
    const double x = along / (friction * normal), kappa = kappa_of_pair();
    const double after = r.sliding_after.value / (r.restitution.value * normal);
    out.print("{:g},{:.4f},{:.6f},{:.5f},{:.1e},{:.5f},{:.4f},{:.4f},{:.5f},{:.3f},{:.4f},{}\n", angle, x,
              r.restitution.value, r.tangential_restitution.value, r.tangential_restitution.error,
              maw_restitution(x, kappa, 0.5 * kappa * sphere_yield), x < 8.0 ? coupling(x) : 0.0,
              r.neglected.tangential_restitution, r.tangential_after.value / along, -r.spin_after.value * c / radius,
              std::atan(after) / degree, r.converged);
  }
}

}  // namespace study
