#pragma once

#include <optional>

#include "stoss/cxx20.hpp"
#include "stoss/relaxation.hpp"

namespace stoss {

/// Frequency at which moduli are taken to be known, rad/s: 10 kHz, of contacts that last 50 µs.
inline constexpr double usual_frequency = 62831.853071795865;

/// An isotropic linear elastic material in SI.
struct Material {
  double young = 0.0;                      ///< E, Pa
  double poisson = 0.0;                    ///< ν of the solid, −1 < ν < ½
  double density = 0.0;                    ///< ρ, kg/m³
  std::optional<double> yield_strength{};  ///< Y in simple tension, Pa, if known
  std::optional<double> loss_time{};       ///< η, s: stress = (1 + η ∂/∂t) elastic stress, if known
  std::optional<double> surface_energy{};  ///< γ, J/m²: two surfaces stick with w = 2√(γ₁γ₂), if known
  std::optional<Relaxation> relaxation{};  ///< in place of η, times in s: then E is E(0)
  std::optional<double> quality{};         ///< in place of both: Q, the same at all frequencies
  double frequency = usual_frequency;      ///< rad/s, at which E is the modulus of a material with a quality
};

/// Kind of body behind a disk: a thin plate (plane stress) or a slice of a long cylinder (plane strain).
enum class Plane { stress, strain };

/// The 2-D Poisson's ratio that the core computes with: ν for plane stress, ν/(1−ν) for plane strain (paper eq. (2)).
/// @throws InvalidInput unless the material's constants are positive and ν in range
[[nodiscard]] double plane_poisson(const Material& material, Plane plane);

/// Loss time η = 1/(Q ω) of a Kelvin–Voigt material, stress = (1 + η ∂/∂t) elastic stress, that has the quality Q at
/// the angular frequency ω: 1/Q is the tangent of the angle by which its strain lags behind, ηω there. A material whose
/// Q does not depend on the frequency, as of most metals, has it at this frequency only; π/(contact time) is that of an
/// impact. There a ball loses 3.54/Q, and with a Q that is the same at all frequencies 2.41/Q: η at 4.62/(contact time)
/// loses as much as this (docs/theory/loss.md).
/// @param frequency ω, in radians per unit of time
/// @throws InvalidInput unless both are positive and finite, and so is η
[[nodiscard]] double loss_time_of_quality(double quality, double frequency);

/// Material of an isotropic solid from the speeds of its longitudinal and transverse waves, as ultrasound measures
/// them: E = ρc_s²(3c_p² − 4c_s²)/(c_p² − c_s²), ν = (c_p² − 2c_s²)/2(c_p² − c_s²) (K. F. Graff, Wave Motion in Elastic
/// Solids, section 5.1).
/// @param c_p, c_s m/s; @param density kg/m³
/// @throws InvalidInput unless all are positive and c_p is above √(4/3) c_s, as in every stable solid
[[nodiscard]] Material material_of_wave_speeds(double c_p, double c_s, double density);

/// SI values of the units of the core. Multiply a dimensionless result by its scale.
struct Scales {
  double length = 0.0;     ///< R, m; of a rod L
  double speed = 0.0;      ///< c = √(E′/ρ), m/s, with E′ = E or, of a disk in plane strain, E/(1−ν²)
  double time = 0.0;       ///< R/c, s
  double frequency = 0.0;  ///< c/R, rad/s
  double force = 0.0;      ///< mc²/R: of a disk πRE′ per thickness, N/m; of a sphere (4π/3)R²E, of a rod EA, N
};

/// Scales of a disk of this material.
/// @param radius R in m
/// @throws InvalidInput as plane_poisson, and for a radius that is not positive
[[nodiscard]] Scales scales(const Material& material, Plane plane, double radius);

}  // namespace stoss
