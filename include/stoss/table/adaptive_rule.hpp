#pragma once

#include <optional>

#include "stoss/poll.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/table/mixture.hpp"
#include "stoss/table/rule_table.hpp"

namespace stoss {

/// How a RuleTable is made.
struct RuleTableOptions {
  double error = 1e-3;      ///< maximum error of ε_n anywhere, 1e-6 … 0.1
  double tolerance = 2e-2;  ///< maximum error of s′ over |v_t| + |Ω₁|R₁ + |Ω₂|R₂ + μ v_n, 1e-4 … 0.5
  std::optional<double> friction{};  ///< μ, where the directions of the bodies act on each other; else nothing
  Beyond beyond = Beyond::error;     ///< or clamp
  int most_values = 100'000;         ///< that are computed, 100 … 10 000 000
  int threads = 0;                   ///< 0: as many as the machine has; the result does not depend on it
  Poll poll{};                       ///< on the calling thread, at least every 50 ms
};

/// Table of the collision rule that is accurate to an error of ε_n and one of s′, interpolation included.
///
/// Where the directions of the bodies do not act on each other, as those of spheres and of equal disks, ε_n is the
/// restitution_function or the pair_table of this error, and the rule holds for any friction. Else both are computed
/// together, at one friction. The grid of s′ begins with six speeds per decade and four values of z, and is refined as
/// that of a pair_table. Velocity and spins have equal shares of s; what each of them alone changes is in the errors.
/// It grows with the contact, so a range of speeds that reaches up to where it leaves too little of the tolerance is
/// refused.
/// @param slowest,fastest 1e-8 … 1, in c of the first body, slowest < fastest; with friction μ up to 1/9μ
/// @throws InvalidInput for arguments out of range, for a friction that is missing or not needed, and for bodies
///         without a law along their surface; NotConverged if some value does not reach its share of an error, or more
///         values are needed
[[nodiscard]] RuleTable rule_table(const RefinableContact& contact, double slowest, double fastest,
                                   const RuleTableOptions& options = {});

/// The same of a mixture. @param smallest,largest ratio of radii, as of pair_table
[[nodiscard]] RuleTable rule_table(const Mixture& mixture, double slowest, double fastest, double smallest,
                                   double largest, const RuleTableOptions& options = {});

}  // namespace stoss
