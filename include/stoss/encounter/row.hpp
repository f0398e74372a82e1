#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stoss/encounter/encounter.hpp"
#include "stoss/row/row.hpp"

/// A row as a JSON document:
///
///   {"format": "stoss row 1",
///    "bodies": [{"kind": "sphere", "radius": 0.01, "material": "glass"}, {"kind": "sphere", "radius": 0.02, …}],
///    "before": "wall", "after": {"kind": "half-space", "material": "glass"},
///    "gaps": [0, 1e-6, 0],
///    "vibration": [{"body": 1, "order": 2, "index": 0, "energy": 0.1, "phase": 0}]}
///
/// Bodies are as in the document of an encounter, the others as what the first meets. All but `bodies` may be left out.
namespace stoss {

/// A row as users give it. With a material of the first body all is in SI; else sizes are in any consistent units, and
/// speeds in c of the first body.
struct GivenRow {
  std::vector<Participant> bodies{};   ///< from left to right
  bool wall_before = false;            ///< on their left
  std::optional<Participant> after{};  ///< on their right: a wall, or what stands there
  std::vector<double> gaps{};          ///< between neighbours, what stands at an end included; empty: all touch
  Vibration vibration{};               ///< of the bodies by their numbers, before
};

/// Reads a document. @throws InvalidInput with one line: what is wrong where, and what is allowed
[[nodiscard]] GivenRow row_from_json(std::string_view text);

/// Writes a document that reads back as the same row, on one line.
[[nodiscard]] std::string to_json(const GivenRow& row);

/// The first body with what its units are.
[[nodiscard]] Encounter first_of(const GivenRow& row);

/// The row in units of the first body. @throws InvalidInput as validate of encounters of the first body with each other
[[nodiscard]] Row row_of(const GivenRow& given);

/// Speeds as they are given, in c of the first body, with that of what stands at the end of the row.
/// @param speeds of the bodies from left to right; those that are left out rest @throws InvalidInput
[[nodiscard]] std::vector<double> speeds_in_c(const GivenRow& given, const std::vector<double>& speeds);

/// The velocities after all contacts of a row as it is given, in c of the first body, without that of what stands at
/// its end. @throws as row and row_of
[[nodiscard]] RowResult row(const GivenRow& given, const std::vector<double>& speeds, const RowOptions& options = {});

/// What material_warnings says of the two bodies of each contact, at the speed at which they alone would press each
/// other as much: ½μv² = ⅖Fδ of spheres with the greatest force and compression. Nothing without materials.
/// @param work Fδ of each contact from left to right, in mc² of the first body, or NaN @throws as row_of
[[nodiscard]] std::vector<std::string> material_warnings(const GivenRow& given, const std::vector<double>& work);

/// One motion of it, for trajectories: of all bodies, that which stands at its end included.
/// @param cutoff c/R of the first body @throws as row_impact and row_of
[[nodiscard]] RowImpact row_impact(const GivenRow& given, const std::vector<double>& speeds, double cutoff,
                                   const Poll& poll = {}, const RowWatch& watch = {});

}  // namespace stoss
