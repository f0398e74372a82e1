#pragma once

#include <string>

#include "stoss/impact/impact.hpp"
#include "stoss/impact/oblique.hpp"
#include "stoss/quantity.hpp"

namespace stoss {

/// Quantities of one impact. Energies are shares of the initial energy.
[[nodiscard]] const Quantities<Impact>& impact_quantities();

/// What a reader should know of a body that stays (Impact::remaining), one line: ε is 0 of an infinite plate alone.
[[nodiscard]] std::string note_of_staying();

/// The same of a body that leaves a plate with little, one line; "" where ε is 0, which is staying, or 0.2 and more.
/// Such a contact lasts so long that waves from the edge of a real plate often come back in it: a clamped disc of 20
/// thicknesses threw a ball back with 0.95 of its speed where the infinite plate has 0.17 (docs/tutorials/cad.md).
[[nodiscard]] std::string note_of_a_plate(double restitution);

/// Where the energy is after an impact.
[[nodiscard]] const Quantities<EnergyLedger>& ledger_quantities();

/// Quantities of one oblique impact but for its ledger, and what was asked for.
[[nodiscard]] const Quantities<ObliqueImpact>& oblique_impact_quantities();

/// Quantities of one instant of an oblique impact.
[[nodiscard]] const Quantities<ObliqueSnapshot>& oblique_snapshot_quantities();

/// Where the energy is after an oblique impact.
[[nodiscard]] const Quantities<ObliqueLedger>& oblique_ledger_quantities();

/// Quantities of one kept mode after an impact.
[[nodiscard]] const Quantities<ModeEnergy>& mode_energy_quantities();

/// Quantities of one instant of an impact.
[[nodiscard]] const Quantities<Snapshot>& snapshot_quantities();

}  // namespace stoss
