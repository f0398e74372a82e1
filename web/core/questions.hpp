#pragma once

#include <emscripten/val.h>

#include <memory>
#include <optional>
#include <string>

#include "stoss/encounter/encounter.hpp"

/// The questions of web/src/core/protocol.ts and local.ts, each with its answer.
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

/// What a question is about, and who gets what comes one by one.
struct Question {
  emscripten::val given, deliver;

  [[nodiscard]] double number(const char* name) const { return given[name].as<double>(); }
  [[nodiscard]] std::string text(const char* name) const { return given[name].as<std::string>(); }

  /// That of its document; the last few are kept, with the modes of their bodies.
  [[nodiscard]] std::shared_ptr<const Meeting> meeting() const;
};

namespace answer {

/// The table of kinds and the named materials, as JSON: web/plugins/kinds.mjs writes them for the page.
[[nodiscard]] emscripten::val kinds(const Question& asked);

/// Units of the first body, and the elastic numbers of both in these. @throws InvalidInput for what cannot meet
[[nodiscard]] emscripten::val units(const Question& asked);

/// A speed in c of the first body. @throws InvalidInput for one out of range
[[nodiscard]] emscripten::val speed(const Question& asked);

/// What a text stands for, as the command reads it. @throws InvalidInput with its name
[[nodiscard]] emscripten::val number(const Question& asked);
[[nodiscard]] emscripten::val series(const Question& asked);

/// ε at one speed, or at many of them, one by one.
[[nodiscard]] emscripten::val restitution(const Question& asked);
[[nodiscard]] emscripten::val curve(const Question& asked);

/// The header in C of ε between two speeds, as `stoss table --format c` writes it but for its provenance.
[[nodiscard]] emscripten::val header(const Question& asked);

/// One impact in time, as `stoss impact --cutoff` computes it, and frames of it, one by one.
/// @throws InvalidInput as impact; NotConverged where it does not end
[[nodiscard]] emscripten::val collision(const Question& asked);
[[nodiscard]] emscripten::val frames(const Question& asked);

/// The shape of a mode of a body.
[[nodiscard]] emscripten::val shape(const Question& asked);

}  // namespace answer
}  // namespace stoss::web
