#pragma once

#include <vector>

#include "bodies/plate/sheet.hpp"
#include "bodies/surface/medium_surface.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::plate {

/// A plate for the waves on its upper face, in units of length and of c = √(E/ρ) and ρ of the uppermost layer.
struct Lamina {
  Contour contour;
  std::vector<Sheet> sheets;  ///< from the top down, all of finite thickness
  double thickness;           ///< of all

  /// What its modes of a wave number are found in: parts_of it, or the whole where these would lose digits in bending.
  [[nodiscard]] const std::vector<Sheets>& parts(double wave_number) const {
    constexpr double long_waves = 0.02;
    return wave_number * thickness < long_waves ? whole : halves;
  }
  std::vector<Sheets> whole, halves;

  /// Of each kind of layers, if there are several: its moduli here over those at first.
  std::vector<double> stiffness;
  double swinging;  ///< frequency up to which waves swing in the impact; faster ones follow the force

  /// Speeds of the fastest layer.
  double pressure_speed, shear_speed;

  /// Share of the waves between k and k + dk in the answer of a contact point, per dk: k/2π of a plate, 1/π of a strip.
  [[nodiscard]] double weight(double wave_number) const;
};

[[nodiscard]] Lamina lamina(Contour contour, std::vector<Sheet> sheets, std::vector<double> stiffness = {},
                            double swinging = 0.0);

/// Modes of pressure and vertically polarised shear waves, which move the surface along its normal and along k.
[[nodiscard]] std::vector<PlaneWaves> plane_waves(const Lamina& plate, double cutoff, double duration,
                                                  const Poll& poll);

/// The same for loads on the normal alone.
[[nodiscard]] std::vector<SurfaceWaves> normal_waves(const std::vector<PlaneWaves>& waves);

/// The same for loads along y on rings, on average over the direction of k: half by these waves, and half by those that
/// are polarised along the surface.
[[nodiscard]] std::vector<SurfaceWaves> waves_along(const std::vector<PlaneWaves>& waves, const Lamina& plate,
                                                    double cutoff, const Poll& poll);

/// Static compliance of all waves of a wave number, per dk, in both directions, and Σ 1/ω⁴ in place of Σ 1/ω².
[[nodiscard]] Flexibility plane_compliance(const Lamina& plate, double wave_number);
[[nodiscard]] Flexibility plane_second_moment(const Lamina& plate, double wave_number);

/// The same along the surface, as waves_along.
[[nodiscard]] double compliance_along(const Lamina& plate, double wave_number);
[[nodiscard]] double second_moment_along(const Lamina& plate, double wave_number);

/// Cutoff at which a plate would have about so many modes.
[[nodiscard]] double cutoff_of_count(const Lamina& plate, double count, double duration);

inline constexpr double share_of_duration = 0.9;  ///< for which the quadratures hold

/// A wave number of a quadrature, and its weight.
struct WaveNumber {
  double k, weight;
};

/// Those of which waves with ω ≤ cutoff are kept, for times up to 0.9 duration. The last is below highest_kept.
/// @throws InvalidInput where these are more than are computed
[[nodiscard]] std::vector<WaveNumber> wave_numbers(const Lamina& plate, double cutoff, double duration,
                                                   const Poll& poll = {});

/// Wave number above which no modes are below the cutoff.
[[nodiscard]] double highest_kept(const Lamina& plate, double cutoff, const Poll& poll = {});

/// The layers that waves with ω ≤ cutoff reach from the upper face: deeper ones, in which slower waves may run, move
/// this face by less than rounding.
[[nodiscard]] Sheets reached(const Sheets& part, double k, double cutoff);

}  // namespace stoss::bodies::plate
