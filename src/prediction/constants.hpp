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
  bool computed = false;  ///< whether the computed channels are others
};

/// One for each uncertain constant of the bodies, in the order of Material; of named materials those of the list.
/// @throws InvalidInput for the name of no constant, and uncertainties out of range
[[nodiscard]] std::vector<Variant> variants(const Encounter& encounter, const PredictionOptions& options);

}  // namespace stoss::prediction
