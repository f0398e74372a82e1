#include <string>
#include <variant>
#include <vector>

#include "results.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/errors.hpp"
#include "stoss/prediction/prediction.hpp"
#include "stoss/prediction/quantities.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

val answer(const Prediction& of) {
  val quantities = val::object(), channels = val::array();
  for (const auto& each : prediction_quantities()) put(quantities, each.name, each, of, UnitSystem::sphere_si);
  for (std::size_t i = 0; i < channel_names.size(); ++i) {
    const bool model = is_model(static_cast<Channel>(i));
    channels.call<void>("push",
                        object({{"name", std::string(channel_names[i])}, {"share", of.shares[i]}, {"model", model}}));
  }
  const auto influence = [](const Influence& its) {
    return object({{"constant", its.constant}, {"uncertainty", its.uncertainty}, {"change", its.change}});
  };
  return object({{"speed", of.speed},
                 {"quantities", quantities},
                 {"channels", channels},
                 {"dominant", std::string(channel_names[static_cast<std::size_t>(of.dominant)])},
                 {"influences", list(of.influences, influence)},
                 {"warnings", list(of.warnings, [](const std::string& line) { return val(line); })}});
}

/// ε with all channels at many speeds in m/s, one by one; of several, without those at which a law is not known.
val prediction(const Question& asked) {
  const auto meeting = asked.meeting();
  const std::vector<double> speeds = numbers(asked.given["speeds"]);
  const val constants = asked.given["constants"];
  const PredictionOptions how{.influences = constants.isUndefined() || constants.as<bool>(),
                              .tolerance = asked.number("tolerance", PredictionOptions{}.tolerance),
                              .threads = 1,
                              .poll = say_alive};
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    try {
      asked.deliver(answer(predict(meeting->encounter, {speeds[i]}, how).front()), i);
    } catch (const InvalidInput& error) {
      if (speeds.size() == 1 || error.name() != "speed") throw;
    }
  }
  return val::undefined();
}

/// Speeds at which models begin to matter. @throws InvalidInput for what is not predicted
val thresholds(const Question& asked) {
  const Thresholds its = stoss::thresholds(encounter_from_json(asked.text("document")));
  val made = object({{"sticking", its.sticking}});
  if (its.yield) made.set("yield", *its.yield);
  return made;
}

}  // namespace

EMSCRIPTEN_BINDINGS(prediction) {
  emscripten::function("prediction", &answered<prediction>);
  emscripten::function("thresholds", &answered<thresholds>);
}

}  // namespace stoss::web
