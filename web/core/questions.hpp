#pragma once

#include <emscripten/bind.h>

#include <memory>
#include <optional>
#include <string>

#include "javascript.hpp"
#include "stoss/encounter/encounter.hpp"

/// The questions of web/package/questions.ts, and those of web/src/core/local.ts: each is a function of JavaScript,
/// bound where it is answered.
namespace stoss::web {

/// Who meets whom, with the contacts that are made of it.
struct Meeting {
  /// @throws InvalidInput as encounter_from_json and RefinableContact
  explicit Meeting(const std::string& document);

  /// Of the first body, or of what it meets.
  [[nodiscard]] const Solid& solid(int number) const { return number == 0 ? first : second.value(); }

  [[nodiscard]] bool against_unbounded() const;

  /// Whether that is a plate or a strip.
  [[nodiscard]] bool against_plate() const;

  /// Whether one of both is a body by its modes at a point, which is known up to some cutoff.
  [[nodiscard]] bool of_file() const;

  /// Value of a unit of the first body in what the page is given: 1, or in SI.
  [[nodiscard]] double unit(Dimension dimension) const { return si ? unit_in_si(dimension, *si) : 1.0; }

  /// Name of what the page is given, as R/c or s.
  [[nodiscard]] std::string unit_name(Dimension dimension) const;

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
  /// Or another, where it is not given.
  [[nodiscard]] double number(const char* name, double otherwise) const {
    return given[name].isUndefined() ? otherwise : number(name);
  }
  [[nodiscard]] std::string text(const char* name) const { return given[name].as<std::string>(); }

  /// That of its document; the last few are kept, with the modes of their bodies.
  [[nodiscard]] std::shared_ptr<const Meeting> meeting() const;
};

/// What JavaScript gets of a function that answers a question: { value }, or { error } with one line and, of a refused
/// input, { refusal } with its parts; no exception leaves for JavaScript, which cannot read those of C++.
[[nodiscard]] emscripten::val answered(emscripten::val (*answer)(const Question&), const Question& asked);

/// That of one function, to be bound.
template <emscripten::val (*answer)(const Question&)>
emscripten::val answered(const emscripten::val& given, const emscripten::val& deliver) {
  return answered(answer, {given, deliver});
}

}  // namespace stoss::web
