#include <string>

#include "common.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/prediction/prediction.hpp"
#include "stoss/restitution/curve.hpp"

namespace bench {
namespace {

constexpr double drop_speed = 1.0;  // m/s

const stoss::Encounter& steel_on_steel() {
  static const stoss::Encounter made = stoss::encounter_from_json(
      R"({"first": {"kind": "sphere", "radius": 0.01, "material": "bearing steel"},
          "against": {"kind": "half-space", "material": "bearing steel"}})");
  return made;
}

void add_prediction(const std::string& what, bool influences) {
  add("drop test: " + what, [=](benchmark::State& state) {
    double lost = 0.0;
    for (auto _ : state) {
      stoss::PredictionOptions options;
      options.influences = influences, options.threads = 1;
      const double value = stoss::predict(steel_on_steel(), {drop_speed}, options).front().restitution.value;
      lost = 1.0 - value * value;
    }
    state.counters[lost_fraction_counter] = lost;
  });
}

}  // namespace

void add_predictions() {
  add("drop test: the computed value alone", [](benchmark::State& state) {
    double lost = 0.0;
    for (auto _ : state) {
      const double in_c = stoss::speed_in_c(steel_on_steel(), drop_speed);
      lost = stoss::restitution(refinable(steel_on_steel()), in_c, {.absolute = 1e-5}).lost_fraction.value;
    }
    state.counters[lost_fraction_counter] = lost;
  });
  add_prediction("all channels", false);
  add_prediction("all channels, each constant varied", true);
}

}  // namespace bench
