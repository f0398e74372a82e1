// What pressure and friction do to each other: a disk at a rigid wall beside two equal disks at twice its speeds, which
// differ by that alone; and ε_n of disks at a wall with friction.
#include <fmt/os.h>

#include <cmath>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "study.hpp"

namespace study {

// A half-plane that slides on a rigid wall flutters from μ = 1 on where ν = 0, and 1.06 where it is 0.33.
constexpr double most_friction = 0.8;

void write_coupling(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print("# A disk at a rigid wall beside two equal disks at twice its speeds; beta = (1 - nu)/2; made by `make ");
  out.print("results`.\n");
  out.print(
      "poisson,beta,speed[c],friction,x,restitution,tangential_restitution,tangential_restitution_error,equal_disks,"
      "equal_disks_error,friction_loss,converged\n");
  const std::vector<double> obliquities{0.25, 0.5, 1.0, 2.0, 3.0};
  for (const double poisson : {0.0, 0.33, 0.7}) {
    const double beta = 0.5 * (1.0 - poisson);
    const stoss::RefinableContact wall = disk_at_wall(poisson), pair = equal_disks(poisson);
    for (const double speed : {0.003, 0.05}) {
      const auto without = rules(pair, 2.0 * speed, 0.3, obliquities, 1e-2);
      for (const double ratio : {0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 3.0, 5.0}) {
        if (ratio * beta > most_friction) continue;
        const auto with = rules(wall, speed, ratio * beta, obliquities, 1e-2);
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

namespace {

void write_normal(fmt::ostream& out, const char* against, const stoss::RefinableContact& contact, double poisson,
                  double speed) {
  const stoss::Estimate central = rules(contact, speed, 0.0, {0.0}, 1e-2).front().restitution;
  for (const double friction : {0.1, 0.3, 0.8}) {
    std::vector<double> obliquities{0.0, 0.5, 1.0, 2.0, 4.0, 7.0};
    std::erase_if(obliquities, [&](double x) { return x * friction * speed > 1.0; });  // v_t is at most c
    const auto found = rules(contact, speed, friction, obliquities, 1e-2);
    for (std::size_t i = 0; i < found.size(); ++i) {
      out.print("{},{:g},{:g},{:g},{:g},{:.6f},{:.1e},{:.6f},{:.1e},{}\n", against, poisson, speed, friction,
                obliquities[i], found[i].restitution.value, found[i].restitution.error, central.value, central.error,
                found[i].converged);
    }
  }
}

}  // namespace

void write_normal(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print("# eps_n of disks with friction, and without; soft: a half-plane with a third of the disk's E; made by ");
  out.print("`make results`.\n");
  out.print("against,poisson,speed[c],friction,x,restitution,restitution_error,without_friction,");
  out.print("without_friction_error,converged\n");
  for (const double poisson : {0.0, 0.33, 0.7}) {
    const stoss::RefinableContact wall = disk_at_wall(poisson);
    for (const double speed : {1e-3, 1e-2, 0.1, 0.3}) write_normal(out, "wall", wall, poisson, speed);
  }
  const stoss::BodyMaker soft = stoss::half_plane(stoss::HalfPlane{.poisson = disk_poisson, .young = 1.0 / 3.0});
  write_normal(out, "soft", {stoss::disk(disk_poisson), soft}, disk_poisson, 0.1);
}

}  // namespace study
