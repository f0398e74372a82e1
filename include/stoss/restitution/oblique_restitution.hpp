#pragma once

#include <string>
#include <vector>

#include "stoss/errors.hpp"
#include "stoss/impact/oblique.hpp"
#include "stoss/poll.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// What an oblique impact comes to as the resolution grows, with its errors and the runs that led to it. Units as in
/// ObliqueImpact.
struct ObliqueRestitution {
  Estimate restitution;             ///< ε_n
  Estimate sliding_after;           ///< s′
  Estimate tangential_restitution;  ///< ε_t = −s′/s, whose error is that of s′ over |s|: infinite where s = 0
  double tolerance = 0.0;           ///< asked for
  bool converged = false;           ///< whether it is met
  std::string reason;               ///< why not
  bool unstable = false;            ///< friction so high that waves of any length grow while all slides: what the runs
                                    ///< agree on holds where something damps those that they do not resolve
  std::vector<Run> runs;            ///< from coarse to fine
  ObliqueImpact finest;             ///< the last of them, whole
  long steps = 0;                   ///< of all runs
};

struct ObliqueRestitutionOptions {
  double tolerance = 1e-2;  ///< error of ε_n, and of s′ over the greater of |s| and μv, 1e-4 … 0.5
  Poll poll{};
};

/// An oblique impact that misses its tolerance. `best` is the best value that was reached; best.reason, also in what(),
/// gives the reason.
class ObliqueNotConverged : public NotConverged {
 public:
  explicit ObliqueNotConverged(ObliqueRestitution result);
  ObliqueRestitution best;
};

/// ε_n and ε_t from oblique impacts at rising cutoffs. Their errors are three times the maximum difference of a run
/// from the two before it, scaled to its cutoff as 1/ω_c where both directions act on each other (disks) and as
/// ω_c^−1.4 elsewhere, and that of s′ is at least what the number n of contact points leaves open: 0.8 μv n^{−3/2} of
/// disks, (1/κ) μv/n² of spheres (docs/theory/oblique.md). Much larger bodies take part as a whole. Without friction,
/// the central impact.
/// @throws InvalidInput as oblique_impact; ObliqueNotConverged if the cutoffs up to 64 are not enough; NotConverged if
///         no three impacts end
[[nodiscard]] ObliqueRestitution oblique_restitution(const RefinableContact& contact, double speed,
                                                     const Obliquity& obliquity,
                                                     const ObliqueRestitutionOptions& options = {});

}  // namespace stoss
