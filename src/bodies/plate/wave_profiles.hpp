#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "bodies/plate/depth_response.hpp"
#include "bodies/plate/plate_waves.hpp"
#include "bodies/plate/wave_numbers.hpp"

namespace stoss::bodies::plate {

/// kz at which e^{−kz} is below 1e-17.
inline constexpr double deepest_phase = 40.0;

/// How one wave number of a quadrature moves a plate at some depths: u_r and u_z of each, with the shapes J₁(kr) and
/// J₀(kr), sin kx and cos kx.
struct WaveProfiles {
  double wave_number;
  Eigen::MatrixXd kept;    ///< per coordinate of each kept wave
  Eigen::VectorXd others;  ///< per load, by the slow answer of the waves that are not kept
};

/// A wave on the surface.
struct Amplitude {
  double omega;
  double normal, along;  ///< as in PlaneWaves
};

/// Makes them.
///
/// The profile of a wave is the displacement at its frequency by that of the surface. What the others add is the mean
/// value over a circle z = ρe^{iα} of the answer to a load less that of the kept waves,
///
///   T(z) Q⁻¹(z) − Σ_kept T(ω_l²) φφᵀ/(ω_l² − z),
///
/// in which low frequencies, where answers are as good as infinite, are none (Branches).
class ProfileMaker {
 public:
  ProfileMaker(const Lamina& plate, const std::vector<double>& depths);

  /// @param waves  the kept ones of all parts, of each part those below the cutoff, as plane_waves has them
  [[nodiscard]] WaveProfiles of(const WaveNumber& number, const std::vector<Amplitude>& waves, double cutoff) const;

  /// Of a wave number of which none are kept.
  [[nodiscard]] WaveProfiles of(const WaveNumber& number) const;

 private:
  [[nodiscard]] const std::vector<DepthResponse>& responses(double wave_number) const;

  Lamina plate_;
  Eigen::Index rows_;
  std::vector<DepthResponse> whole_, halves_;  ///< of the parts of the plate
};

}  // namespace stoss::bodies::plate
