#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/errors.hpp"

namespace stoss {

/// What `make` returns; its refusals say that they are of what is met.
template <typename Make>
auto with_prefix_against(Make make) {
  try {
    return make();
  } catch (const InvalidInput& error) {
    throw error.within("against");
  }
}

/// A number that was given, or what holds without it.
[[nodiscard]] double given_or(const Participant& of, std::string_view name, double otherwise);

/// η, that of the material where none is given, of a plate of its uppermost layer; 0 of a rigid body.
[[nodiscard]] double loss_time_of(const Participant& of);

/// Yield strength of its own, or that of its material, Pa; nothing of a rigid body, and where none is known.
[[nodiscard]] std::optional<double> strength_of(const Participant& of);

/// The material of the list that a body has by its name; null for numbers of its own.
[[nodiscard]] const NamedMaterial* named_of(const Participant& of);

/// E(0) of a body, and of its layers below, over its modulus, which of a material with a quality is that at its
/// frequency; 1 of others.
/// @param size of the first body, for the band of what has none
[[nodiscard]] std::vector<double> stiffening(const Participant& of, double size);

/// How its material relaxes, with times in the unit of time of the numbers of its solid; of layers that differ not at
/// all, as they are in the solid.
[[nodiscard]] Relaxation relaxation_of(const Encounter& encounter, const Participant& of, const Solid& solid);

/// The losses of the layers of a plate that differ, in the unit of time of its numbers; else none.
[[nodiscard]] std::vector<MaterialLoss> layer_losses(const Encounter& encounter, const Participant& of,
                                                     const Solid& plate);

/// 1/m of a ball with a material, 1/kg, by itself and with its extra mass; 0 of what has no radius.
[[nodiscard]] double inverse_mass_of_solid(const Participant& of);
[[nodiscard]] double inverse_mass_of(const Participant& of);

/// Unit of length of the first body, as given: its radius, its length, or own_length.
[[nodiscard]] double size_of_first(const Encounter& encounter);

/// (1 − ν²)/E of a body with a material, 1/Pa; 0 of a rigid one.
[[nodiscard]] double softness_of(const Participant& of);

/// All numbers of the kind of a participant: as they were given, of its material in SI, or the default.
/// @param poisson that it has where none is given
/// @param radius  with which the modulus of what has none is expressed
/// @throws InvalidInput for numbers that the kind does not have, that are missing, or that the material gives too
[[nodiscard]] Values all_values(const Participant& of, std::optional<double> poisson, double radius);

/// The same of its layers below the first, downwards, but for what all layers share.
[[nodiscard]] std::vector<Values> values_below(const Participant& of, std::optional<double> poisson, double radius);

}  // namespace stoss
