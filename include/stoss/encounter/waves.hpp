#pragma once

#include <cstddef>
#include <vector>

#include "stoss/bodies/half_space/field.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/poll.hpp"

/// What is seen of a half-space when an impact is repeated: below its surface and on it.
namespace stoss {

/// Below the surface of a half-space at several instants, in units of the first body: displacements and their rates of
/// change, on depths × distances.
struct Waves {
  std::vector<double> time, force, center, lateral, normal, lateral_velocity, normal_velocity;
};

/// The impact again, with a half-space that is good for as long as its waves are looked at.
/// @param times  ascending, R/c of the first body
/// @param points in R of the first body
/// @throws InvalidInput unless the second is a half-space or a half-plane
[[nodiscard]] Waves waves(const Encounter& encounter, const Impact& impact, const Vibration& vibration,
                          const std::vector<double>& times, bodies::half_space::PlaneGrid points,
                          const Poll& poll = {});

/// Speeds of the waves of the half-space that is met, in c of the first body. @throws as waves
[[nodiscard]] bodies::half_space::WaveSpeeds wave_speeds(const Encounter& encounter);

/// Places of the surface of the second body, a half-space, in R of the first: instants × lateral distances.
struct Surfaces {
  std::vector<double> lateral, place;
};

/// @param reach the largest lateral distance, R; @param count of them
[[nodiscard]] Surfaces surfaces(const Contact& contact, const Impact& impact, const std::vector<Frame>& frames,
                                double reach, std::size_t count, const Poll& poll = {});

}  // namespace stoss
