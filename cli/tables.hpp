#pragma once

#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/quasistatic/point_rayleigh.hpp"
#include "stoss/quasistatic/rayleigh.hpp"
#include "stoss/quasistatic/static_contact.hpp"
#include "stoss/restitution/extrapolation.hpp"
#include "stoss/restitution/restitution.hpp"
#include "stoss/vibration/bounce.hpp"
#include "stoss/vibration/distribution.hpp"
#include "table.hpp"

namespace stoss::cli {

/// A disk or a sphere that is pressed to a wall: by the law of compression, and as the exact static contact has it.
struct Compressed {
  double compression = 0.0;
  double force = 0.0;
  double energy = 0.0;
  double half_width = 0.0;  ///< of a sphere, radius of the contact
  quasistatic::StaticContact contact;
};

/// How each kind of result is shown. Names, dimensions and order are those of the core; here are widths and marks.
[[nodiscard]] const Table<Restitution>& restitution_table();
[[nodiscard]] const Table<Run>& run_table();
[[nodiscard]] const Table<ExtrapolatedRestitution>& extrapolation_table();
[[nodiscard]] const Table<SoftImpact>& soft_impact_table();
[[nodiscard]] const Table<Impact>& impact_table();
[[nodiscard]] const Table<EnergyLedger>& ledger_table();
[[nodiscard]] const Table<ModeEnergy>& mode_energy_table();
[[nodiscard]] const Table<Snapshot>& snapshot_table();
[[nodiscard]] const Table<Sample>& sample_table();
[[nodiscard]] const Table<DistributionSummary>& distribution_table();
[[nodiscard]] const Table<Bounce>& bounce_table();

[[nodiscard]] const Table<bodies::disk::Mode>& mode_table();
[[nodiscard]] const Table<bodies::sphere::Mode>& sphere_mode_table();
[[nodiscard]] const Table<quasistatic::RayleighEstimate>& rayleigh_table();
[[nodiscard]] const Table<quasistatic::DrivenMode>& driven_mode_table();
[[nodiscard]] const Table<quasistatic::PointRayleighEstimate>& point_rayleigh_table();
[[nodiscard]] const Table<Compressed>& compression_table();
[[nodiscard]] const Table<Compressed>& point_compression_table();

}  // namespace stoss::cli
