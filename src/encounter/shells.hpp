#pragma once

#include <optional>

#include "encounter/participant.hpp"
#include "stoss/quasistatic/point_hertz.hpp"

namespace stoss {

/// Mass over that of a solid sphere: 1 − b³ of a hollow one, 1 of others.
[[nodiscard]] double share_of_mass(const Participant& of);

/// Speed at which bodies with materials begin to yield, m/s, hollow ones among them: where the pressure of Hertz'
/// contact reaches 1.6 Y. The energy of the
/// approach is that of both, ½mv² = Hertz' energy + F²/2k, with k of the shells as springs (ShellLimit).
[[nodiscard]] double yield_speed_with_shells(const Encounter& encounter, const quasistatic::PointPair& pair,
                                             double mass, double strength);

/// The same of both as they are given, by their modes too; nothing where neither has a strength, or both are flat.
[[nodiscard]] std::optional<double> yield_speed_with_shells(const Encounter& encounter);

/// Whether one of both is hollow.
[[nodiscard]] bool has_shell(const Encounter& encounter);

}  // namespace stoss
