#include <string>
#include <variant>
#include <vector>

#include "results.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/prediction/prediction.hpp"
#include "stoss/prediction/quantities.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

/// Channels in their order, each with its share of the energy.
val channels(const Prediction& of) {
  val made = val::array();
  for (std::size_t i = 0; i < channel_names.size(); ++i) {
    made.call<void>("push", object({{"name", val(std::string(channel_names[i]))},
                                    {"share", val(of.shares[i])},
                                    {"model", val(is_model(static_cast<Channel>(i)))}}));
  }
  return made;
}

val influences(const Prediction& of) {
  val made = val::array();
  for (const auto& [constant, uncertainty, change] : of.influences) {
    made.call<void>("push",
                    object({{"constant", val(constant)}, {"uncertainty", val(uncertainty)}, {"change", val(change)}}));
  }
  return made;
}

val answer(const Prediction& of) {
  val quantities = val::object(), warnings = val::array();
  for (const auto& each : prediction_quantities()) put(quantities, each.name, each, of, UnitSystem::sphere_si);
  for (const std::string& each : of.warnings) warnings.call<void>("push", each);
  return object({{"speed", val(of.speed)},
                 {"quantities", quantities},
                 {"channels", channels(of)},
                 {"dominant", val(std::string(channel_names[static_cast<std::size_t>(of.dominant)]))},
                 {"influences", influences(of)},
                 {"warnings", warnings}});
}

/// ε with all channels at many speeds in m/s, one by one.
val prediction(const Question& asked) {
  const auto meeting = asked.meeting();
  const std::vector<double> speeds = numbers(asked.given["speeds"]);
  const val constants = asked.given["constants"];
  const PredictionOptions how{.influences = constants.isUndefined() || constants.as<bool>(),
                              .tolerance = asked.number("tolerance", PredictionOptions{}.tolerance),
                              .threads = 1,
                              .poll = say_alive};
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    asked.deliver(answer(predict(meeting->encounter, {speeds[i]}, how).front()), i);
  }
  return val::undefined();
}

/// Speeds at which models begin to matter. @throws InvalidInput for what is not predicted
val thresholds(const Question& asked) {
  const Thresholds its = stoss::thresholds(encounter_from_json(asked.text("document")));
  val made = object({{"sticking", val(its.sticking)}});
  if (its.yield) made.set("yield", *its.yield);
  return made;
}

}  // namespace

EMSCRIPTEN_BINDINGS(prediction) {
  emscripten::function("prediction", &answered<prediction>);
  emscripten::function("thresholds", &answered<thresholds>);
}

}  // namespace stoss::web
