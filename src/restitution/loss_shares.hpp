#pragma once

#include "stoss/contact/contact.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Energy of the translation before the impact, as a share of the initial energy.
[[nodiscard]] double translation_before(const EnergyLedger& ledger);

/// Fills what each body keeps, and what the material takes, so that it adds up to the loss of a concluded result.
///
/// The ledger of the finest impact adds up to its own 1 − ε². What the result has less is energy that the modes above
/// the cutoff would have given back, each body its part of `unresolved`; of a half-space they give nothing back. What
/// the ledger misses, its energy error, belongs to each share as much as the share is large.
void apportion_losses(const Contact& contact, Restitution& result);

}  // namespace stoss
