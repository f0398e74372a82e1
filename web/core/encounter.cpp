#include <array>
#include <cmath>
#include <string>
#include <variant>

#include "questions.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/version.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

/// @param unit that of the modulus
val elastic(const Solid& solid, double unit) {
  val made = val::object();
  std::visit(
      [&](const auto& its) {
        made.set("young", its.young / unit);
        if constexpr (requires { its.poisson; }) made.set("poisson", its.poisson);
      },
      solid);
  return made;
}

/// With solid spheres in place of hollow ones, whose modes take a second where the shell is thin.
Encounter without_holes(Encounter encounter) {
  for (Participant* each : {&encounter.first, &encounter.against}) {
    if (each->values.erase("inner") > 0) each->kind = "sphere";
  }
  return encounter;
}

val version(const Question&) { return val(std::string(stoss::version())); }

/// Units of the first body, and the elastic numbers of both in these. @throws InvalidInput for what cannot meet
val units(const Question& asked) {
  constexpr double fewest_modes = 4.0;  // cutoff, c/R
  constexpr double quick = 0.5;         // c
  using enum Dimension;
  const Meeting meeting(asked.text("document"));
  // The ratios of two bodies are checked where they meet; of the fewest modes that is soon done.
  if (meeting.of_file()) {
    (void)meeting.contact.at(0);
  } else if (meeting.second) {
    (void)contact_of(without_holes(meeting.encounter), fewest_modes, quick);
  }
  // A rod in SI keeps its numbers.
  const auto* rod = std::get_if<Rod>(&meeting.first);
  const double modulus = rod != nullptr ? rod->young : 1.0;
  val made = object({{"speed", meeting.unit(Dimension::speed)},
                     {"time", meeting.unit(time)},
                     {"frequency", meeting.unit(frequency)},
                     {"first", elastic(meeting.first, modulus)}});
  if (meeting.si) made.set("modulus", meeting.encounter.first.material->density * std::pow(meeting.si->speed, 2));
  if (meeting.second) made.set("second", elastic(*meeting.second, modulus));
  return made;
}

/// A speed in c of the first body. @throws InvalidInput for one out of range
val speed(const Question& asked) {
  return val(speed_in_c(encounter_from_json(asked.text("document")), asked.number("speed")));
}

/// What a text stands for, as the command reads it. @throws InvalidInput with its name
val number(const Question& asked) { return val(parse_number(asked.text("name"), asked.text("text"))); }

/// [[share, time], ...], as documents have them. @throws InvalidInput with its name
val relaxation(const Question& asked) {
  const Relaxation its = parse_relaxation(asked.text("name"), asked.text("text"));
  return list(its.terms, [](const RelaxationTerm& term) {
    return list(std::array{term.share, term.time}, [](double number) { return val(number); });
  });
}

val series(const Question& asked) { return float64_array(parse_series(asked.text("name"), asked.text("text"))); }

}  // namespace

EMSCRIPTEN_BINDINGS(encounter) {
  emscripten::function("version", &answered<version>);
  emscripten::function("units", &answered<units>);
  emscripten::function("speed", &answered<speed>);
  emscripten::function("number", &answered<number>);
  emscripten::function("relaxation", &answered<relaxation>);
  emscripten::function("series", &answered<series>);
}

}  // namespace stoss::web
