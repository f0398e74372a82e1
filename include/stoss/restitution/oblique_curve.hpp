#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "stoss/restitution/oblique.hpp"

namespace stoss {

/// Where a collision rule is asked for.
struct ObliqueCase {
  double speed = 0.0;  ///< v_n, c
  Obliquity before;
};

/// v_t of a body that comes in at an angle to the normal. @param angle degrees, between −90 and 90
/// @throws InvalidInput for another angle
[[nodiscard]] double tangential_at(double angle, double speed);

/// Receives collision rules in the order of their cases, as CurveObserver does.
using ObliqueObserver = std::function<void(std::size_t index, const ObliqueRestitution& result)>;

struct ObliqueCurveOptions {
  ObliqueOptions each{};  ///< of each rule; `poll` is called as that of a curve
  int threads = 0;        ///< 0: as many as the machine has; results do not depend on it
};

/// Checks the cases and the options.
/// @throws InvalidInput for what is out of range, and with friction for what has no answer along its surface
void validate(const RefinableContact& contact, const std::vector<ObliqueCase>& cases,
              const ObliqueCurveOptions& options);

/// Computes collision rules and hands them over one by one. Cases that follow one another at one speed share their
/// impacts along the normal where they can. One that does not converge does not end the others: `converged` is false,
/// with a reason, and its values are NaN where no two impacts end.
/// @throws InvalidInput as validate, before anything is computed; what observer and poll throw
void oblique_curve(const RefinableContact& contact, const std::vector<ObliqueCase>& cases,
                   const ObliqueCurveOptions& options, const ObliqueObserver& observer);

/// Computes collision rules and returns them all.
[[nodiscard]] std::vector<ObliqueRestitution> oblique_curve(const RefinableContact& contact,
                                                            const std::vector<ObliqueCase>& cases,
                                                            const ObliqueCurveOptions& options = {});

}  // namespace stoss
