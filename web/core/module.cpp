// What the worker calls: one function for every question of web/src/core/protocol.ts.
#include <emscripten/bind.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "collision.hpp"
#include "encounter.hpp"
#include "javascript.hpp"
#include "restitution.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/inside.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

/// What a question is about, and who gets what comes one by one.
struct Question {
  val given, deliver;

  [[nodiscard]] double number(const char* name) const { return given[name].as<double>(); }
  [[nodiscard]] std::string text(const char* name) const { return given[name].as<std::string>(); }
};

/// The encounters of the last questions, with the modes of their bodies.
std::shared_ptr<const Meeting> meeting(const Question& asked) {
  constexpr std::size_t kept = 4;
  static std::vector<std::pair<std::string, std::shared_ptr<const Meeting>>> known;
  const std::string document = asked.text("document");
  const auto found = std::find_if(known.begin(), known.end(), [&](const auto& each) { return each.first == document; });
  auto its = found != known.end() ? found->second : std::make_shared<const Meeting>(document);
  if (found != known.end()) known.erase(found);
  known.emplace_back(document, its);
  if (known.size() > kept) known.erase(known.begin());
  return its;
}

/// The last collision.
Collision& collision(const Question& asked) {
  struct Last {
    std::string document;
    double speed, cutoff;
    Collision its;
  };
  static std::unique_ptr<Last> last;
  const std::string document = asked.text("document");
  const double speed = asked.number("speed"), cutoff = asked.number("cutoff");
  if (!last || last->document != document || last->speed != speed || last->cutoff != cutoff) {
    last = std::make_unique<Last>(Last{document, speed, cutoff, Collision(meeting(asked), speed, cutoff)});
  }
  return last->its;
}

bodies::PolarGrid points(const val& grid) { return {numbers(grid["radius"]), numbers(grid["angle"])}; }

bodies::half_space::PlaneGrid below(const val& grid) {
  const val given = grid["below"];
  if (given.isUndefined()) return {};
  return {numbers(given["distance"]), numbers(given["depth"])};
}

val shape(const Question& asked) {
  const std::shared_ptr<const Meeting> its = meeting(asked);
  const int body = asked.given["body"].as<int>();
  if (body == 1 && !its->second) throw InvalidInput("body: got the second, allowed the first");
  const Interior made = mode_shape(its->solid(body), asked.given["order"].as<int>(), asked.given["index"].as<int>(),
                                   points(asked.given["grid"]));
  return object({{"radial", float32_array(made.radial)}, {"tangential", float32_array(made.tangential)}});
}

const std::map<std::string, val (*)(const Question&)>& questions() {
  static const std::map<std::string, val (*)(const Question&)> all{
      {"kinds", [](const Question&) { return val(table_of_kinds()); }},
      {"units", [](const Question& asked) { return units(Meeting(asked.text("document"))); }},
      {"speed",
       [](const Question& asked) {
         return val(own_speed(encounter_from_json(asked.text("document")), asked.number("speed")));
       }},
      {"number", [](const Question& asked) { return val(parse_number(asked.text("name"), asked.text("text"))); }},
      {"series",
       [](const Question& asked) { return float64_array(parse_series(asked.text("name"), asked.text("text"))); }},
      {"restitution",
       [](const Question& asked) {
         return restitution(*meeting(asked), asked.number("speed"), asked.number("tolerance"));
       }},
      {"curve",
       [](const Question& asked) {
         curve(*meeting(asked), numbers(asked.given["speeds"]), asked.number("tolerance"), asked.deliver);
         return val::undefined();
       }},
      {"header",
       [](const Question& asked) {
         return val(header(*meeting(asked), asked.number("slowest"), asked.number("fastest"), asked.number("error")));
       }},
      {"collision", [](const Question& asked) { return collision(asked).series(); }},
      {"frames",
       [](const Question& asked) {
         const val grid = asked.given["grid"];
         collision(asked).frames(numbers(asked.given["times"]), points(grid), below(grid), asked.deliver);
         return val::undefined();
       }},
      {"shape", shape},
  };
  return all;
}

/// { value } of the answer, or { error } with one line: no exception leaves for JavaScript, which cannot read those of
/// C++.
val ask(const std::string& question, const val& given, const val& deliver) {
  std::string what;
  try {
    return object({{"value", questions().at(question)({given, deliver})}});
  } catch (const std::bad_alloc&) {
    what = "memory: the computation needs more than there is (a greater tolerance needs less)";
  } catch (const std::exception& error) {
    what = error.what();
  }
  return object({{"error", val(what)}});
}

}  // namespace

EMSCRIPTEN_BINDINGS(stoss) { emscripten::function("ask", &ask); }

}  // namespace stoss::web
