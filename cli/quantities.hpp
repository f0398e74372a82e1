#pragma once

#include "quantity.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/quasistatic/rayleigh.hpp"
#include "stoss/quasistatic/static_contact.hpp"
#include "stoss/restitution/extrapolation.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss::cli {

/// A disk that is pressed to a wall: by the law of compression, and as the exact static contact has it.
struct Compressed {
  double compression = 0.0;
  double force = 0.0;
  double energy = 0.0;
  double half_width = 0.0;
  quasistatic::StaticContact contact;
};

/// What is said of each kind of result, in the order of CSV columns and JSON members. A new quantity is a new line.
[[nodiscard]] const Quantities<Restitution>& restitution_quantities();
[[nodiscard]] const Quantities<Run>& run_quantities();
[[nodiscard]] const Quantities<ExtrapolatedRestitution>& extrapolation_quantities();
[[nodiscard]] const Quantities<SoftImpact>& soft_impact_quantities();
[[nodiscard]] const Quantities<Impact>& impact_quantities();
[[nodiscard]] const Quantities<EnergyLedger>& ledger_quantities();
[[nodiscard]] const Quantities<ModeEnergy>& mode_quantities();
[[nodiscard]] const Quantities<Snapshot>& snapshot_quantities();

[[nodiscard]] const Quantities<bodies::disk::Mode>& eigenmode_quantities();
[[nodiscard]] const Quantities<quasistatic::RayleighEstimate>& slow_impact_quantities();
[[nodiscard]] const Quantities<quasistatic::DrivenMode>& driven_mode_quantities();
[[nodiscard]] const Quantities<Compressed>& compression_quantities();

}  // namespace stoss::cli
