#pragma once

#include "stoss/poll.hpp"
#include "stoss/table/mixture.hpp"
#include "stoss/table/pair_table.hpp"

namespace stoss {

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
/// @param smallest,largest ratio of radii, 1e-3 … 1e3, smallest < largest; of one material the range may lie on
///                          either side of 1, or on both
/// @throws InvalidInput for arguments out of range, and as RefinableContact; NotConverged if some value does not reach
///         its share of the error, or more values are needed
[[nodiscard]] PairTable pair_table(const Mixture& mixture, double slowest, double fastest, double smallest,
                                   double largest, const PairTableOptions& options = {});

}  // namespace stoss
