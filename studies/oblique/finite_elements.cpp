// Disks at a rigid wall beside independent finite elements: of linear kinematics, which is what stoss computes, and of
// finite rotation, in which the disk turns while it touches.
#include <fmt/os.h>

#include "study.hpp"

namespace study {

namespace {

struct Reference {
  const char* kinematics;
  double speed, friction, tangential, restitution, tangential_restitution;  // 0: without tangential motion
};

// Own finite elements, without modes: 5e-5 of ε_n, 2e-4 of ε_t (1e-3 for μ = 1), if linear. Those with finite rotation
// are checked by their balances alone.
constexpr Reference references[] = {
    {"linear", 0.1, 0.1, 0.2, 0.94700, -0.7118},  {"linear", 0.1, 0.3, 0.1, 0.94595, 0.4926},
    {"linear", 0.1, 1.0, 0.0, 0.94877, 0.0},      {"linear", 0.1, 1.0, 0.1, 0.94155, 0.4759},
    {"turning", 0.1, 0.3, 0.1, 0.9522, 0.4805},   {"turning", 0.1, 1.0, 0.2, 0.9758, 0.553},
    {"turning", 0.03, 0.3, 0.015, 0.9833, 0.598}, {"turning", 0.01, 0.3, 0.01, 0.9836, 0.486},
};

}  // namespace

void write_finite_elements(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print("# A disk at a rigid wall, nu = {}, beside finite elements; made by `make results`.\n", disk_poisson);
  out.print(
      "kinematics,speed[c],friction,tangential[c],finite_elements,finite_elements_tangential,restitution,"
      "restitution_error,tangential_restitution,tangential_restitution_error,spin_after[c/R],contact_time[R/c]\n");
  const stoss::RefinableContact wall = disk_at_wall(disk_poisson);
  for (const Reference& each : references) {
    const stoss::ObliqueRestitution r = stoss::oblique_restitution(
        wall, each.speed, stoss::Obliquity{.tangential = each.tangential, .friction = each.friction},
        {.tolerance = 2e-3});
    out.print("{},{:g},{:g},{:g},{:.5f},{:.4f},{:.6f},{:.1e},{:.5f},{:.1e},{:.6f},{:.4f}\n", each.kinematics,
              each.speed, each.friction, each.tangential, each.restitution, each.tangential_restitution,
              r.restitution.value, r.restitution.error, r.tangential_restitution.value, r.tangential_restitution.error,
              r.spin_after.value, r.finest.normal.contact_time);
  }
}

}  // namespace study
