// A ball meets a wall at 45 degrees, with friction: what becomes of its spin, and of the motion along the wall.
#include <cstdio>
#include <stoss/bodies/sphere.hpp>
#include <stoss/restitution.hpp>

int main() {
  const stoss::RefinableContact ball(stoss::sphere(0.3));
  const double speed = 0.01;
  const stoss::Obliquity before{.tangential = stoss::tangential_at(45.0, speed), .friction = 0.1};
  const stoss::ObliqueRestitution after = stoss::oblique_restitution(ball, speed, before);
  std::printf("normal:     %.6f ± %.6f\n", after.restitution.value, after.restitution.error);
  std::printf("tangential: %.4f ± %.4f\n", after.tangential_restitution.value, after.tangential_restitution.error);
  std::printf("spin:       %.6f ± %.6f c/R\n", after.spin_after.value, after.spin_after.error);
}
