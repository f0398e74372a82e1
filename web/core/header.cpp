#include <array>
#include <cstdio>
#include <string>

#include "questions.hpp"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/c_source.hpp"
#include "stoss/version.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

/// A number for what a header says of itself.
std::string text(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
  return buffer.data();
}

/// The header in C of ε between two speeds, as `stoss table --format c` writes it but for its provenance.
val header(const Question& asked) {
  const auto meeting = asked.meeting();
  const double slowest = asked.number("slowest"), fastest = asked.number("fastest");
  const double error = asked.number("error", FunctionOptions{}.error);
  const RestitutionFunction function = restitution_function(
      meeting->contact, speed_in_c(meeting->encounter, slowest), speed_in_c(meeting->encounter, fastest),
      {.error = error, .beyond = Beyond::clamp, .threads = 1, .poll = say_alive});
  TableLabel label{.unit = meeting->unit_name(Dimension::speed), .scale = meeting->unit(Dimension::speed)};
  label.provenance = {"stoss " + std::string(stoss::version()) + ": table", name(meeting->contact.at(0)),
                      "speed[" + label.unit + "]: " + text(slowest) + ":" + text(fastest), "error: " + text(error)};
  return val(c_header(function, label));
}

}  // namespace

EMSCRIPTEN_BINDINGS(header) { emscripten::function("header", &answered<header>); }

}  // namespace stoss::web
