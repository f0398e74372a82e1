#include "bodies/half_space/medium.hpp"

#include <cmath>
#include <numbers>

#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "check.hpp"
#include "numeric/special_functions.hpp"

namespace stoss::bodies::half_space {

double Medium::compliance(double wave_number) const {
  return contour == Contour::ball ? softness / std::numbers::pi : 2.0 * softness / (std::numbers::pi * wave_number);
}

double Medium::measure(double inner, double outer) const {
  const double width = outer - inner;
  return contour == Contour::ball ? std::numbers::pi * width * (outer + inner) : 2.0 * width;
}

double Medium::second_moment() const {
  double sum = 0.0;
  for (const Spectrum& spectrum : spectra) sum += spectrum.share * spectrum.second_moment;
  return sum;
}

double Medium::shape(double phase) const {
  return contour == Contour::ball ? numeric::bessel_j0(phase) : std::cos(phase);
}

double Medium::slope(double phase) const {
  return contour == Contour::ball ? numeric::bessel_j01(phase).first : std::sin(phase);
}

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
  return {kernel,
          contour,
          pressure_speed,
          shear_speed,
          along ? sphere::softness_along(poisson) : normal,
          along ? shear_speed : pressure_speed,
          spectra(kernel, direction)};
}

}  // namespace stoss::bodies::half_space
