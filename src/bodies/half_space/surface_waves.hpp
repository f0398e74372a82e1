#pragma once

#include <vector>

#include "bodies/half_space/medium.hpp"
#include "bodies/surface/medium_surface.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::half_space {

/// The quadratures hold for times up to this share of the duration.
inline constexpr double share_of_duration = 0.9;

/// The spectrum of the surface between two values of x = ω/(c_s k), as a quadrature.
struct Piece {
  std::vector<double> x, weight;  ///< weight: ρ(x) dx
};

/// ∫ρ/x² and ∫ρ/x⁴.
struct Rest {
  double compliance = 0.0, moment = 0.0;
};

/// The continuum of one kind.
struct Continuum {
  const LambKernel& kernel;
  const Spectrum& spectrum;

  /// ρ(x)
  [[nodiscard]] double density(double x) const { return spectrum.density(kernel, x); }
  [[nodiscard]] double pressure_speed() const;

  /// Up to x ≤ end, for times up to `turns` over c_s k. Kinds that begin alike have the same x.
  [[nodiscard]] Piece up_to(double end, double turns) const;

  /// From x to infinity.
  [[nodiscard]] Rest beyond(double x) const;
};

/// A wave number of a quadrature, and its weight.
struct WaveNumber {
  double k, weight;
};

/// Those of which waves with ω ≤ cutoff are kept.
[[nodiscard]] std::vector<WaveNumber> wave_numbers(const Medium& medium, double cutoff, double duration);

/// All wave numbers of which waves are kept, k ≤ cutoff/c_R. The quadratures reproduce the response of the surface for
/// times up to 0.9 duration and more, by which what comes later hardly matters: forces that far apart are the beginning
/// and the end of a contact.
[[nodiscard]] std::vector<SurfaceWaves> surface_waves(const Medium& medium, double cutoff, double duration,
                                                      const Poll& poll);

/// Cutoff at which that would be about so many waves.
[[nodiscard]] double cutoff_of_count(const Medium& medium, double count, double duration);

}  // namespace stoss::bodies::half_space
