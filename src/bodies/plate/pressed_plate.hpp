#pragma once

#include <vector>

#include "bodies/plate/plate_waves.hpp"
#include "bodies/surface/pressed.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::plate {

/// What loads on the upper face of a plate move one of its points by, in the units of the plate.
struct PressedPlate {
  std::vector<Motion> motions;  ///< for each load
  Motion unresolved;            ///< of the first, what the waves of the upper half of the frequencies add
};

/// Each wave q̈ + ω²q = F h(ka), h(x) = 3(sin x − x cos x)/x³ for Hertz's pressure on a circle of the radius a, is moved
/// exactly by a force that is a polygon in time; waves above the cutoff follow slowly. The sum over k is Gauss's, good
/// for the last instant and the distance. Near the load, where short waves count that are not kept, J. Boussinesq's
/// answer of a half-space is left out of the sum and added as a whole.
/// @param loads the first with the greatest circle
/// @throws InvalidInput as wave_numbers
[[nodiscard]] PressedPlate pressed_plate(const Lamina& plate, double poisson, double distance, double depth,
                                         const Instants& instants, const std::vector<PressedLoad>& loads, double cutoff,
                                         const Poll& poll);

/// Number of waves that are kept for this, about.
[[nodiscard]] double count_of_waves(const Lamina& plate, double distance, const Instants& instants, double cutoff);

}  // namespace stoss::bodies::plate
