#pragma once

#include <vector>

#include "bodies/half_space/lamb_kernel.hpp"
#include "bodies/surface/medium_surface.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::half_space {

/// What a half-space and a half-plane have in common, in units of length, c = √(E/ρ) and ρ.
///
/// A load of wave number k that varies slowly displaces the surface by compliance(k) per load and dk, softness/π on a
/// half-space and 2 softness/(πk) on a half-plane, one that varies like e^{st} by Γ(s/(c_s k)) times as much. Σ 1/ω⁴
/// over Σ 1/ω² of all waves is a number over (c_s k)².
struct Medium : MediumSurface {
  LambKernel kernel;              ///< of the 3-D Poisson's ratio
  std::vector<Spectrum> spectra;  ///< of what moves the surface

  /// Speed of the Rayleigh wave, the slowest.
  [[nodiscard]] double rayleigh_speed() const { return kernel.rayleigh_root * shear_speed; }
};

/// Throws InvalidInput unless such a body can have this Poisson's ratio: −0.95 … 0.4999, 2-D of a cylinder … 0.995.
void require_poisson(Contour contour, double poisson);

/// @param poisson 2-D for a cylinder
/// @param direction along the surface of a half-space only
/// @throws InvalidInput as require_poisson
[[nodiscard]] Medium medium(Contour contour, double poisson, Direction direction = Direction::normal);

}  // namespace stoss::bodies::half_space
