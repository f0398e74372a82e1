#pragma once

#include <emscripten/val.h>

#include <optional>
#include <string>

#include "stoss/encounter/encounter.hpp"

namespace stoss::web {

/// Who meets whom, with the contacts that are made of it.
struct Meeting {
  /// @throws InvalidInput as encounter_from_json and RefinableContact
  explicit Meeting(const std::string& document);

  /// Of the first body, or of what it meets.
  [[nodiscard]] const Solid& solid(int number) const { return number == 0 ? first : second.value(); }

  [[nodiscard]] bool against_half_space() const;

  /// Value of a unit of the first body in what the page is given: 1, or in SI.
  [[nodiscard]] double unit(Dimension dimension) const { return si ? unit_in_si(dimension, *si) : 1.0; }

  /// Name of what the page is given, as R/c or s; and of a unit of the first body.
  [[nodiscard]] std::string unit_name(Dimension dimension) const;
  [[nodiscard]] std::string own_unit_name(Dimension dimension) const;

  Encounter encounter;
  Solid first;
  std::optional<Solid> second;
  std::optional<Scales> si;
  RefinableContact contact;
};

/// Units of the first body, and the elastic numbers of both in these: Units of web/src/core/protocol.ts.
/// @throws InvalidInput for bodies that cannot meet
[[nodiscard]] emscripten::val units(const Meeting& meeting);

/// The kinds and the named materials, as JSON: web/plugins/kinds.mjs writes them for the page.
[[nodiscard]] std::string table_of_kinds();

}  // namespace stoss::web
