// What pressure and friction do to each other: a disk at a rigid wall beside two equal disks at twice its speeds, which
// differ by that alone; and ε_n of disks at a wall with friction.
#include <fmt/os.h>

#include <cmath>

#include "study.hpp"

namespace study {

void write_coupling(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print("# A disk at a rigid wall beside two equal disks at twice its speeds; beta = (1 - nu)/2; made by `make ");
  out.print("results`.\n");
  out.print(
      "poisson,beta,speed[c],friction,x,restitution,tangential_restitution,tangential_restitution_error,equal_disks,"
      "equal_disks_error,friction_loss,converged\n");
  const std::vector<double> obliquities{0.25, 0.5, 1.0, 2.0, 3.0, 4.0};
  for (const double poisson : {0.0, 0.33, 0.7}) {
    const double beta = 0.5 * (1.0 - poisson);
    const stoss::RefinableContact wall = disk_at_wall(poisson), pair = equal_disks(poisson);
    for (const double speed : {0.003, 0.05}) {
      const auto without = rules(pair, 2.0 * speed, 0.3, obliquities, 5e-3);
      for (const double ratio : {0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0}) {
        const auto with = rules(wall, speed, ratio * beta, obliquities, 5e-3);
        for (std::size_t i = 0; i < with.size(); ++i) {
          const stoss::Estimate &one = with[i].tangential_restitution, &other = without[i].tangential_restitution;
          out.print("{:g},{:g},{:g},{:.6g},{:g},{:.5f},{:.4f},{:.1e},{:.4f},{:.1e},{:.5f},{}\n", poisson, beta, speed,
                    ratio * beta, obliquities[i], with[i].restitution.value, one.value, one.error, other.value,
                    other.error, with[i].friction_loss.value, with[i].converged && without[i].converged);
        }
      }
    }
  }
}

void write_normal(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print("# eps_n of a disk at a rigid wall with friction, and without; made by `make results`.\n");
  out.print("poisson,speed[c],friction,x,restitution,restitution_error,without_friction,without_friction_error,");
  out.print("converged\n");
  for (const double poisson : {0.0, 0.33, 0.7}) {
    const stoss::RefinableContact wall = disk_at_wall(poisson);
    for (const double speed : {1e-3, 1e-2, 0.1, 0.3}) {
      const stoss::Estimate central = rules(wall, speed, 0.0, {0.0}, 5e-3).front().restitution;
      for (const double friction : {0.1, 0.3, 1.0}) {
        const std::vector<double> obliquities{0.0, 0.5, 1.0, 2.0, 4.0, 7.0};
        const auto found = rules(wall, speed, friction, obliquities, 5e-3);
        for (std::size_t i = 0; i < found.size(); ++i) {
          out.print("{:g},{:g},{:g},{:g},{:.6f},{:.1e},{:.6f},{:.1e},{}\n", poisson, speed, friction, obliquities[i],
                    found[i].restitution.value, found[i].restitution.error, central.value, central.error,
                    found[i].converged);
        }
      }
    }
  }
}

}  // namespace study
