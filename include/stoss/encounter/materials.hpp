#pragma once

#include <string_view>
#include <vector>

#include "stoss/material.hpp"

namespace stoss {

/// By how much the constants of a material differ from sample to sample: each is known within a factor of 1 + u. `loss`
/// is what the material loses, 1/Q.
struct Uncertainties {
  double young = 0.0, poisson = 0.0, density = 0.0, loss = 0.0, yield_strength = 0.0, surface_energy = 0.0;
};

/// A typical material with its name. It has one quality Q at all frequencies, or a spectrum, or no loss that is known.
struct NamedMaterial {
  std::string_view name;
  Material material;                 ///< E at its frequency, of contacts of 50 µs or 1 ms; with a spectrum E(0)
  std::string_view source;           ///< of modulus, Poisson's ratio, density and loss
  std::string_view strength_source;  ///< of the yield strength
  std::string_view surface_source;   ///< of the surface energy
  Uncertainties uncertainties{};
  bool sound = false;  ///< its rebounds are of sound, smooth, dry samples: others lose ten times as much and more
};

/// Typical materials. Yours differs, rubber and rock by factors: measure it. What has no yield strength is brittle, or
/// not known well enough.
///
/// The qualities are orders of magnitude. Those of metals lie in the range of
/// L. Cremer and M. Heckl, Structure-Borne Sound (1988); the others are typical without a single source.
[[nodiscard]] const std::vector<NamedMaterial>& named_materials();

/// The material of that name, in upper or lower case. @throws InvalidInput if there is none, with the names that there
/// are
[[nodiscard]] const Material& named_material(std::string_view name);

/// The same with its sources.
[[nodiscard]] const NamedMaterial& material_of_the_list(std::string_view name);

}  // namespace stoss
