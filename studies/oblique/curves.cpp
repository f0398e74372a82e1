// ε_t against s/(μ v_n) of spheres and disks, slow and fast.
#include <fmt/os.h>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "study.hpp"

namespace study {

namespace {

constexpr double tolerance = 5e-3;

void write(fmt::ostream& out, const char* who, const stoss::RefinableContact& contact, double speed, double scale,
           double friction, const std::vector<double>& obliquities) {
  const auto found = rules(contact, scale * speed, friction, obliquities, tolerance);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const stoss::ObliqueRestitution& r = found[i];
    out.print("{},{:g},{:g},{:.3g},{:.7f},{:.1e},{:.5f},{:.1e},{}\n", who, speed, friction, obliquities[i],
              r.restitution.value, r.restitution.error, r.tangential_restitution.value, r.tangential_restitution.error,
              r.converged);
  }
}

}  // namespace

void write_curves(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print("# Oblique impact, nu = {} of spheres and of the half-space, {} of disks; made by `make results`.\n",
            sphere_poisson, disk_poisson);
  out.print("# equal_disks: each disk moves at the speed, along the normal and along the surface.\n");
  out.print(
      "bodies,speed[c],friction,x,restitution,restitution_error,tangential_restitution,tangential_restitution_error,"
      "converged\n");
  for (const double x : range(0.1, 8.0, 0.1)) {
    const double value = maw_restitution(x, kappa(sphere_poisson), chi(sphere_poisson));
    out.print("maw,0,0.1,{:.3g},1,0,{:.5f},1e-05,true\n", x, value);
  }
  const stoss::RefinableContact sphere(stoss::sphere(sphere_poisson));
  for (const double speed : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1}) {
    write(out, "sphere", sphere, speed, 1.0, 0.1, range(0.1, 8.0, 0.1));
  }
  const stoss::RefinableContact on_half_space(stoss::sphere(sphere_poisson),
                                              stoss::half_space(stoss::HalfSpace{.poisson = sphere_poisson}));
  for (const double speed : {1e-4, 1e-3, 1e-2}) {
    write(out, "half_space", on_half_space, speed, 1.0, 0.1, range(0.1, 8.0, 0.1));
  }
  const stoss::RefinableContact wall = disk_at_wall(disk_poisson), pair = equal_disks(disk_poisson);
  for (const double speed : {1e-4, 1e-2, 0.1}) {
    write(out, "equal_disks", pair, speed, 2.0, 0.1, range(0.2, 8.0, 0.2));
    for (const double friction : {0.1, 0.3}) {
      write(out, "disk", wall, speed, 1.0, friction, range(0.2, 8.0, 0.2));
    }
  }
}

}  // namespace study
