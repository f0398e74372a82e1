#pragma once

#include <cstddef>
#include <vector>

#include "stoss/bodies/half_space/field.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/poll.hpp"

/// What is seen of what has no end sideways, a half-space or a plate, when an impact is repeated: below its surface and
/// on it. Half-planes and strips are meant too.
namespace stoss {

/// Below the surface at several instants, in units of the first body: displacements and their rates of
/// change, on depths × distances.
struct Waves {
  std::vector<double> time, force, center, lateral, normal, lateral_velocity, normal_velocity;
};

/// What meets, with a half-space or a plate that is good for as long as its waves are looked at.
/// @param latest time, and points, in the units of the first body
/// @throws InvalidInput unless the second is one
[[nodiscard]] Contact lasting(const Encounter& encounter, double cutoff, double latest,
                              const bodies::half_space::PlaneGrid& points, const Poll& poll = {});

/// The impact again, with what is met as `lasting`.
/// @param times  ascending, R/c of the first body
/// @param points in R of the first body
/// @throws InvalidInput as lasting, and for points below a plate
[[nodiscard]] Waves waves(const Encounter& encounter, const Impact& impact, const Vibration& vibration,
                          const std::vector<double>& times, bodies::half_space::PlaneGrid points,
                          const Poll& poll = {});

/// Speeds of the waves in the material of the surface that is met, in c of the first body. @throws as waves
[[nodiscard]] bodies::half_space::WaveSpeeds wave_speeds(const Encounter& encounter);

/// Places of the surface of the second body, which has no end sideways, in R of the first: instants × lateral
/// distances.
struct Surfaces {
  std::vector<double> lateral, place;
  std::vector<double> lower;  ///< of the lower face of a plate no thicker than the reach; else empty
};

/// @param contact, impact of the encounter
/// @param reach the largest lateral distance, R; @param count of them
/// @throws InvalidInput as lasting
[[nodiscard]] Surfaces surfaces(const Encounter& encounter, const Contact& contact, const Impact& impact,
                                const std::vector<Frame>& frames, double reach, std::size_t count,
                                const Poll& poll = {});

}  // namespace stoss
