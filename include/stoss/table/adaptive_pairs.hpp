#pragma once

#include <functional>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/poll.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/table/pair_table.hpp"

namespace stoss {

/// Bodies of any ratio of radii and two materials, or one.
struct Mixture {
  std::function<RefinableContact(double ratio)> contact;  ///< ratio: radius of the second over that of the first
  bool alike = false;                                     ///< of one material: exchanging the two changes nothing
};

/// Disks of the materials of two; speeds in c of the first. Their radii do not count: of elastic disks ε depends on the
/// ratio of the radii alone. @throws InvalidInput as `disk`, and for a loss time, with which it depends on them
[[nodiscard]] Mixture mixture(const Disk& first, const Disk& second);
[[nodiscard]] Mixture mixture(const Disk& disk);

/// Spheres of the materials of two; speeds in c of the first. @throws InvalidInput as above
[[nodiscard]] Mixture mixture(const Sphere& first, const Sphere& second);
[[nodiscard]] Mixture mixture(const Sphere& sphere);

/// How a PairTable is made.
struct PairTableOptions {
  double error = 1e-3;            ///< maximum error of ε at any speed and ratio, 1e-6 … 0.1
  Beyond beyond = Beyond::error;  ///< or clamp
  int most_values = 100'000;      ///< that are computed, 100 … 10 000 000
  int threads = 0;                ///< 0: as many as the machine has; the result does not depend on it
  Poll poll{};                    ///< on the calling thread, at least every 50 ms
};

/// Table ε(v, r) of a mixture that is accurate to an error of ε, interpolation included: speeds and ratios are added
/// where the values computed so far do not predict those between them.
///
/// It begins with six speeds and six ratios per decade. Every interval of speeds is halved until at all ratios ε
/// computed in its middle differs from the interpolation by no more than 3/8 of the error; then every interval of
/// ratios, in s of PairTable, is halved until the same holds at all speeds of the ratio in its middle, at which the
/// speeds are checked again. What the middles differed by is the error of the interpolation, as in
/// restitution_function. Values are computed to a fifth of the error.
/// @param slowest,fastest   1e-8 … 1, in c of the first body, slowest < fastest
/// @param smallest,greatest ratio of radii, 1e-3 … 1e3, smallest < greatest; of one material the range may lie on
///                          either side of 1, or on both
/// @throws InvalidInput for arguments out of range, and as RefinableContact; NotConverged if some value does not reach
///         its share of the error, or more values are needed
[[nodiscard]] PairTable pair_table(const Mixture& mixture, double slowest, double fastest, double smallest,
                                   double greatest, const PairTableOptions& options = {});

}  // namespace stoss
