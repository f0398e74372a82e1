#pragma once

#include <memory>
#include <string>

#include "stoss/contact/contact.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/vibration.hpp"

namespace stoss {

inline constexpr double most_steps = 5e7;  ///< of an impact

/// @throws InvalidInput for a start that is not of this speed, or not finite
void require_start(const State& start, double speed);

/// One of the bodies. @throws InvalidInput for one that is not there
[[nodiscard]] std::shared_ptr<const Body> required_body(const Contact& contact, int number);

/// @throws InvalidInput for an interval out of range
void require_every(int every);

/// @throws NotConverged for an error of the energy with which the motion is not resolved in time and means nothing
void require_resolved(double energy_error);

/// Fills what an impact is told by, and whether it is beyond small strain.
void fill_inputs(const Contact& contact, double speed, const FixedResolution& resolution, const ImpactOptions& options,
                 Impact& impact);

/// Greatest strain of the bodies in an impact, estimated (Impact::strain).
[[nodiscard]] double greatest_strain(const Contact& contact, double speed, const ImpactOptions& options,
                                     const Impact& impact);

/// "mode (2, 0) of the first body".
[[nodiscard]] std::string named(const Oscillation& mode);

/// @throws InvalidInput for a mode that bodies like these do not have at any cutoff
void require_possible(const Contact& contact, const Oscillation& mode);

}  // namespace stoss
