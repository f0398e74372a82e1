#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stoss/encounter/encounter.hpp"

/// How a material that relaxes is given.
namespace stoss {

/// The relaxation of "0.5:1+0.2:10": shares of E(0) and their times.
/// @param name that refusals say @throws InvalidInput for another text; what the numbers may be says validate
[[nodiscard]] Relaxation parse_relaxation(const std::string& name, std::string_view text);

/// As parse_relaxation reads it back.
[[nodiscard]] std::string text_of(const Relaxation& relaxation);

/// The modulus E(0) of a material whose modulus E∞ after all relaxation is given, E∞/(1 − Σ shares).
/// @throws InvalidInput without a relaxation, and where nothing of the modulus is left
[[nodiscard]] double instantaneous_of_relaxed(double relaxed, const Relaxation& relaxation);

/// Takes the modulus of a body, or of its material, as E∞ in place of E(0). @throws InvalidInput as above
void take_young_as_relaxed(Participant& of);

/// How a body loses energy in its material: in one of three ways, or in none.
struct Losses {
  double loss_time = 0.0;              ///< η
  double quality = 0.0;                ///< Q, the same at all frequencies; 0: none
  double frequency = usual_frequency;  ///< at which the material has its modulus, rad/s
  Relaxation relaxation{};             ///< times in the unit of loss times

  bool operator==(const Losses&) const = default;
};

/// Those that a body has of its own or, without any, those of its material, of a plate of its uppermost layer; a rigid
/// one has none of its material.
/// @throws InvalidInput where there are two, also of a layer below
[[nodiscard]] Losses losses_of(const Participant& of);

/// The same of each layer, from the top down: one for all where the body has losses of its own.
[[nodiscard]] std::vector<Losses> losses_of_layers(const Participant& of);

/// Whether its layers lose energy in different ways.
[[nodiscard]] bool layers_differ(const Participant& of);

/// Whether it, or a layer of it, relaxes otherwise than by a loss time.
[[nodiscard]] bool relaxes(const Participant& of);

/// Refuses bodies that relax, and layers that differ, for what knows one loss time of a body only. @param what refuses
/// them
void refuse_relaxing(const Encounter& encounter, const std::string& what);

}  // namespace stoss
