#pragma once

#include <string>
#include <vector>

#include "stoss/encounter/materials.hpp"
#include "stoss/prediction/prediction.hpp"

namespace stoss::prediction {

/// A constant that is known within a factor of 1 + u, and the encounter in which it is larger by this factor.
struct Variant {
  std::string constant;
  double uncertainty = 0.0;
  Encounter encounter;
  std::optional<double> work_of_adhesion;
  bool elastic = false;          ///< whether the computed channels are others
  double material_factor = 1.0;  ///< times what the material takes
};

/// One for each uncertain constant of the bodies, in the order of Material; of named materials those of the list.
/// @param at the encounter at one speed, as at_speed makes it
/// @throws InvalidInput for the name of no constant, and uncertainties out of range
[[nodiscard]] std::vector<Variant> variants(const Encounter& encounter, const Encounter& at,
                                            const PredictionOptions& options);

/// The encounter with the loss time with which a slow viscous impact loses as much as one of a named material, whose
/// quality is the same at all frequencies: to first order of the loss where the two bodies differ.
/// @param time (m/k)^{2/5} v^{−1/5}, s
[[nodiscard]] Encounter at_speed(const Encounter& encounter, double time);

}  // namespace stoss::prediction
