#pragma once

#include <string>
#include <string_view>

#include "stoss/encounter/encounter.hpp"

/// An encounter as a JSON document:
///
///   {"format": "stoss encounter 1",
///    "first": {"kind": "sphere", "radius": 0.005, "material": "structural steel"},
///    "against": {"kind": "half-space", "material": {"young": 7e10, "poisson": 0.22, "density": 2500}},
///    "vibration": [{"body": "first", "order": 2, "index": 0, "energy": 0.1, "phase": 0}]}
///
/// `against` may be the name of a kind without numbers, as "wall" or "same". All but `first` may be left out. A
/// document of another or a later format is refused. A plate of layers has in place of its numbers a list of those of
/// its layers, from the top down:
///
///   {"kind": "plate", "layers": [{"thickness": 1e-5, "material": "structural steel"}, {"material": "glass"}],
///   "loss_time": 0}
namespace stoss {

/// Reads a document. @throws InvalidInput with one line: what is wrong where, and what is allowed
[[nodiscard]] Encounter encounter_from_json(std::string_view text);

/// Writes a document that reads back as the same encounter, on one line.
[[nodiscard]] std::string to_json(const Encounter& encounter);

/// Reads one of both as a document has it. What it leaves out, and whether its numbers are in their ranges, only a
/// whole encounter tells. @param where what refusals call it @throws InvalidInput as encounter_from_json
[[nodiscard]] Participant participant_from_json(const std::string& where, std::string_view text);

/// Writes it as a document has it, on one line.
[[nodiscard]] std::string to_json(const Participant& participant);

}  // namespace stoss
