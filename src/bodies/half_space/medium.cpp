#include "bodies/half_space/medium.hpp"

#include <cmath>
#include <numbers>

#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "check.hpp"

namespace stoss::bodies::half_space {

void require_poisson(Contour contour, double poisson) {
  if (contour == Contour::ball) {
    sphere::require_poisson(poisson);
  } else {
    stoss::require_poisson(poisson);
  }
}

Medium medium(Contour contour, double poisson, Direction direction) {
  require_poisson(contour, poisson);
  // A half-plane in plane stress with ν₂ moves as one in plane strain with ν₂/(1 + ν₂), with 2μ(1 + ν₂) = E₂ = 1.
  const bool plane = contour == Contour::cylinder;
  const LambKernel kernel = lamb_kernel(plane ? poisson / (1.0 + poisson) : poisson);
  const double shear_speed = 1.0 / std::sqrt(2.0 * (1.0 + poisson));
  const double pressure_speed = shear_speed / std::sqrt(kernel.squared_ratio);
  const double normal = plane ? 1.0 : 1.0 - poisson * poisson;
  const bool along = direction == Direction::along;
  Medium its;
  its.contour = contour;
  its.pressure_speed = pressure_speed;
  its.shear_speed = shear_speed;
  its.softness = along ? sphere::softness_along(poisson) : normal;
  its.leaving_speed = along ? shear_speed : pressure_speed;
  its.kernel = kernel;
  its.spectra = spectra(kernel, direction);
  its.compliance = [plane, softness = its.softness](double wave_number) {
    return plane ? 2.0 * softness / (std::numbers::pi * wave_number) : softness / std::numbers::pi;
  };
  double moment = 0.0;  // in units of 1/(c_s k)²
  for (const Spectrum& spectrum : its.spectra) moment += spectrum.share * spectrum.second_moment;
  its.second_moment = [compliance = its.compliance, moment, shear_speed](double wave_number) {
    const double unit = shear_speed * wave_number;
    return compliance(wave_number) * moment / (unit * unit);
  };
  return its;
}

}  // namespace stoss::bodies::half_space
