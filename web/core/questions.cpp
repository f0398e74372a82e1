#include "questions.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <utility>
#include <vector>

#include "stoss/encounter/document.hpp"
#include "stoss/errors.hpp"

namespace stoss::web {

Meeting::Meeting(const std::string& document)
    : encounter(encounter_from_json(document)),
      first(first_solid(encounter)),
      second(second_solid(encounter)),
      si(si_scales(encounter)),
      contact(refinable(encounter)) {
  if (encounter.vibration.empty()) return;
  throw InvalidInput::out_of_range("vibration", std::to_string(encounter.vibration.size()) + " modes", "none",
                                   "the command and the Python package compute bodies that vibrate before");
}

bool Meeting::against_unbounded() const {
  const Kind& its = kind(encounter.against.kind);
  return !its.wall && !its.bounded;
}

bool Meeting::against_plate() const {
  return second && (std::holds_alternative<Plate>(*second) || std::holds_alternative<Strip>(*second));
}

bool Meeting::of_file() const { return encounter.first.modal || encounter.against.modal; }

std::string Meeting::unit_name(Dimension dimension) const {
  return std::string(stoss::unit_name(dimension, unit_system(encounter)));
}

std::shared_ptr<const Meeting> Question::meeting() const {
  constexpr std::size_t kept = 4;
  static std::vector<std::pair<std::string, std::shared_ptr<const Meeting>>> known;
  const std::string document = text("document");
  const auto found = std::find_if(known.begin(), known.end(), [&](const auto& each) { return each.first == document; });
  auto its = found != known.end() ? found->second : std::make_shared<const Meeting>(document);
  if (found != known.end()) known.erase(found);
  known.emplace_back(document, its);
  if (known.size() > kept) known.erase(known.begin());
  return its;
}

emscripten::val answered(emscripten::val (*answer)(const Question&), const Question& asked) {
  std::string what;
  try {
    return object({{"value", answer(asked)}});
  } catch (const InvalidInput& error) {
    constexpr std::array kinds{"out_of_range", "missing", "conflict"};
    const emscripten::val refusal = object({{"kind", emscripten::val(kinds[static_cast<std::size_t>(error.kind())])},
                                            {"name", emscripten::val(error.name())},
                                            {"got", emscripten::val(error.got())},
                                            {"allowed", emscripten::val(error.allowed())},
                                            {"hint", emscripten::val(error.hint())}});
    return object({{"error", emscripten::val(std::string(error.what()))}, {"refusal", refusal}});
  } catch (const std::bad_alloc&) {
    what = "memory: the computation needs more than there is (a greater tolerance needs less)";
  } catch (const std::exception& error) {
    what = error.what();
  }
  return object({{"error", emscripten::val(what)}});
}

}  // namespace stoss::web
