// The maximum of ε_t over the obliquity, for many ν and speeds: how near elasticity comes to a perfect superball.
#include <fmt/os.h>

#include <algorithm>

#include "stoss/bodies/sphere.hpp"
#include "study.hpp"

namespace study {

namespace {

void write(fmt::ostream& out, const char* who, double poisson, double speed, double scale,
           const stoss::RefinableContact& contact) {
  const auto by_value = [](const auto& a, const auto& b) {
    return a.tangential_restitution.value < b.tangential_restitution.value;
  };
  std::vector<double> obliquities = range(0.2, 4.0, 0.2);
  auto found = rules(contact, scale * speed, 0.1, obliquities, 5e-3);
  const double near = obliquities[std::max_element(found.begin(), found.end(), by_value) - found.begin()];
  obliquities = range(std::max(0.05, near - 0.2), near + 0.2, 0.05);
  found = rules(contact, scale * speed, 0.1, obliquities, 5e-3);
  const auto best = std::max_element(found.begin(), found.end(), by_value);
  out.print("{},{:g},{:g},{:.3g},{:.4f},{:.1e},{:.6f},{}\n", who, poisson, speed, obliquities[best - found.begin()],
            best->tangential_restitution.value, best->tangential_restitution.error, best->restitution.value,
            best->converged);
}

}  // namespace

void write_superball(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print("# Maximum of eps_t over x, to 0.05; equal_disks: each moves at the speed; made by `make results`.\n");
  out.print("bodies,poisson,speed[c],x,tangential_restitution,tangential_restitution_error,restitution,converged\n");
  for (const double poisson : {-0.9, -0.5, 0.0, 0.2, 0.3, 0.4, 0.45, 0.49}) {
    double best = -1.0, at = 0.0;
    for (const double x : range(0.2, 6.0, 0.05)) {
      const double value = maw_restitution(x, kappa(poisson), chi(poisson));
      if (value > best) best = value, at = x;
    }
    out.print("maw,{:g},0,{:.3g},{:.4f},1e-05,1,true\n", poisson, at, best);
    const stoss::RefinableContact sphere(stoss::sphere(poisson));
    for (const double speed : {1e-4, 1e-3, 3e-3, 0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3}) {
      write(out, "sphere", poisson, speed, 1.0, sphere);
    }
  }
  for (const double poisson : {0.0, 0.33, 0.7}) {
    for (const double speed : {1e-3, 0.01, 0.03, 0.1, 0.2}) {
      write(out, "equal_disks", poisson, speed, 2.0, equal_disks(poisson));
    }
  }
}

}  // namespace study
