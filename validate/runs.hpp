#pragma once

#include <array>
#include <functional>
#include <ostream>

#include "stoss/impact/impact.hpp"

namespace validate {

/// How finely a reference impact is resolved.
struct Fineness {
  double cutoff;
  double step;   ///< times the cutoff
  double nodes;  ///< over those of restitution() at this cutoff
};

using Finenesses = std::array<Fineness, 3>;
using Runs = std::array<stoss::Impact, 3>;

/// The same impact at each fineness.
/// @param contact at a cutoff
Runs resolved_runs(const std::function<stoss::Contact(double cutoff)>& contact, double speed,
                   const Finenesses& finenesses);

/// `,value,uncertainty` of each quantity and the line's end: the value of the last run, and the spread of all (of the
/// contact time at least the last run's step).
void write_quantities(std::ostream& out, const Runs& runs);

/// The names of these columns.
inline constexpr const char* quantity_columns =
    "lost_fraction,uncertainty,contact_time,contact_time_uncertainty,impulse_time,impulse_time_uncertainty,"
    "max_force,max_force_uncertainty,max_compression,max_compression_uncertainty";

}  // namespace validate
