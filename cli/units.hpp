#pragma once

#include <optional>
#include <string>

#include "stoss/encounter/encounter.hpp"
#include "stoss/quantity.hpp"

namespace stoss::cli {

/// The units of results: those of the first body and, with a material, SI.
struct Units {
  UnitSystem own = UnitSystem::disk;
  UnitSystem in_si = UnitSystem::disk_si;
  std::optional<Scales> si{};

  /// Name of a unit of the first body, as in R/c; "" for a pure number.
  [[nodiscard]] std::string own_name(Dimension dimension) const { return std::string(unit_name(dimension, own)); }

  /// Name of the SI unit, as in s.
  [[nodiscard]] std::string si_name(Dimension dimension) const { return std::string(unit_name(dimension, in_si)); }

  /// SI value of the unit of the first body; there must be a material.
  [[nodiscard]] double scale(Dimension dimension) const { return unit_in_si(dimension, *si); }
};

/// The units of results of an encounter.
[[nodiscard]] inline Units units_of(const Encounter& encounter) {
  const Kind& first = kind(encounter.first.kind);
  return {first.own, first.si, si_scales(encounter)};
}

}  // namespace stoss::cli
