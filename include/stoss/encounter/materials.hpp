#pragma once

#include <string_view>
#include <vector>

#include "stoss/material.hpp"

namespace stoss {

/// A typical material with its name.
struct NamedMaterial {
  std::string_view name;
  Material material;
  double quality;    ///< Q, at the frequency below; 0: not known well enough
  double frequency;  ///< rad/s, π over the contact time for which the quality is meant
  std::string_view source;
};

/// Typical materials. Yours differs, rubber and rock by factors: measure it. The qualities are orders of magnitude, at
/// contacts of 50 µs, of rubber 1 ms. What has no yield strength is brittle, or not known well enough.
[[nodiscard]] const std::vector<NamedMaterial>& named_materials();

/// The material of that name. @throws InvalidInput if there is none, with the names that there are
[[nodiscard]] const Material& named_material(std::string_view name);

}  // namespace stoss
