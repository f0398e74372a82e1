#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stoss/poll.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Whether the motions along the normal and along the surface act on each other: of disks that are not equal.
/// @throws InvalidInput for bodies without a law along their surface
[[nodiscard]] bool mixes(const RefinableContact& contact, const Poll& poll);

/// A slip for which a table needs the rule.
struct RuleSlip {
  double z = 0.0;        ///< as of TableValues, from −1 to below 1
  bool compare = false;  ///< whether the ways to slide are compared: by the velocity, or the spin of one body, alone
};

/// Slips of a contact at one speed.
struct RuleRequest {
  const RefinableContact* contact;
  double speed;
  std::vector<RuleSlip> slips;
};

/// The rule at one slip, to which velocity and spins have equal shares.
struct RulePoint {
  Estimate restitution;                 ///< ε_n
  Estimate sliding;                     ///< q of RuleValues
  double restitution_difference = 0.0;  ///< most that a single way to slide changes in ε_n
  double sliding_difference = 0.0;      ///< the same in s′, over |s|
};

/// How accurate the points must be.
struct RuleDemand {
  std::optional<double> friction;  ///< where directions mix
  double sliding = 0.0;            ///< error of q
  double tolerance = 0.0;          ///< of the table, of which that is a part
  double restitution = 0.0;        ///< error of ε_n, where directions mix
};

/// The points of each request, on several threads; the result does not depend on them.
/// @param place what a message says of a request, as "speed 0.1 c"
/// @throws NotConverged for a point that does not reach its error; what poll throws
[[nodiscard]] std::vector<std::vector<RulePoint>> computed_rules(const std::vector<RuleRequest>& requests,
                                                                 const RuleDemand& demand, int threads,
                                                                 const Poll& poll,
                                                                 const std::function<std::string(std::size_t)>& place);

}  // namespace stoss
