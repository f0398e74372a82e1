// How ψ₂ of spheres comes to Maw's as they get slower: with the radius of the contact over that of the sphere.
#include <fmt/os.h>

#include <cmath>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "study.hpp"

namespace study {

namespace {

const std::vector<double> psi{0.5, 1.0, 2.0, 3.0, 4.0};

void write(fmt::ostream& out, const stoss::RefinableContact& contact, double poisson, bool half_space) {
  std::vector<double> obliquities;
  for (const double each : psi) obliquities.push_back(each / kappa(poisson));
  for (int i = -12; i <= -2; ++i) {
    const double speed = std::pow(10.0, 0.5 * i);
    const auto found = rules(contact, speed, 0.1, obliquities, half_space ? 2e-3 : 3e-4);
    for (std::size_t k = 0; k < psi.size(); ++k) {
      out.print("{},{:g},{:.6g},{:.6g},{:g},{:.5f},{:.1e},{:.5f},{}\n", half_space ? "half_space" : "wall", poisson,
                speed, contact_radius(poisson, speed, half_space), psi[k],
                found[k].sliding_after.value / (0.1 * speed) * kappa(poisson),
                found[k].sliding_after.error / (0.1 * speed) * kappa(poisson),
                stoss::quasistatic::maw(psi[k], chi(poisson), 1e-6).psi2, found[k].converged);
    }
  }
}

}  // namespace

void write_size(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print("# Spheres at a rigid wall and on a half-space of their material; made by `make results`.\n");
  out.print("against,poisson,speed[c],contact_radius[R],psi1,psi2,psi2_error,maw,converged\n");
  for (const double poisson : {0.0, 0.3, 0.45}) {
    write(out, stoss::RefinableContact(stoss::sphere(poisson)), poisson, false);
    const stoss::BodyMaker half_space = stoss::half_space(stoss::HalfSpace{.poisson = poisson});
    if (poisson == sphere_poisson) write(out, {stoss::sphere(poisson), half_space}, poisson, true);
  }
}

}  // namespace study
