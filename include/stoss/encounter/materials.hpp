#pragma once

#include <string_view>
#include <vector>

#include "stoss/material.hpp"

namespace stoss {

/// By how much the constants of a material differ from sample to sample: each is known within a factor of 1 + u.
struct Uncertainties {
  double young = 0.0, poisson = 0.0, density = 0.0, loss_time = 0.0, yield_strength = 0.0, surface_energy = 0.0;
};

/// A typical material with its name.
struct NamedMaterial {
  std::string_view name;
  Material material;
  double quality;                    ///< Q, at the frequency below; 0: not known well enough
  double frequency;                  ///< rad/s, π over the contact time for which the quality is meant
  std::string_view source;           ///< of modulus, Poisson's ratio and density
  std::string_view strength_source;  ///< of the yield strength
  std::string_view surface_source;   ///< of the surface energy
  Uncertainties uncertainties{};
  Relaxation spectrum{};  ///< how it relaxes, times in s; without terms it has its quality at all frequencies
  bool sound = false;     ///< its rebounds are of sound, smooth, dry samples: others lose ten times as much and more
};

/// Typical materials. Yours differs, rubber and rock by factors: measure it. What has no yield strength is brittle, or
/// not known well enough.
///
/// The qualities are orders of magnitude, at contacts of 50 µs, of rubber 1 ms. Those of metals lie in the range of
/// L. Cremer and M. Heckl, Structure-Borne Sound (1988); the others are typical without a single source.
[[nodiscard]] const std::vector<NamedMaterial>& named_materials();

/// The material of that name, in upper or lower case. @throws InvalidInput if there is none, with the names that there
/// are
[[nodiscard]] const Material& named_material(std::string_view name);

/// The same with its sources.
[[nodiscard]] const NamedMaterial& material_of_the_list(std::string_view name);

/// The material as it relaxes, in place of a loss time that is right at one frequency: with its spectrum, from the
/// modulus E(0) that gives it its modulus at its frequency, or with its quality.
[[nodiscard]] Material relaxing_material(const NamedMaterial& named);

}  // namespace stoss
