// ε of real balls as a function of the speed, in c of the ball as all functions have it.
#include <algorithm>
#include <utility>
#include <vector>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "stoss/prediction/prediction.hpp"

namespace stoss {

PredictedFunction predicted_function(const Encounter& encounter, double slowest, double fastest,
                                     const FunctionOptions& options, PredictionOptions models) {
  require("error", options.error, {1e-4, 0.1, true, true, "1e-4 to 0.1"}, "maximum error of the restitution");
  models.influences = false, models.threads = options.threads, models.poll = options.poll;
  const double unit = speed_unit(encounter);
  double by_models = 0.0;
  const auto computed = [&](const std::vector<double>& speeds) {
    std::vector<double> in_si;
    in_si.reserve(speeds.size());
    for (const double speed : speeds) in_si.push_back(std::clamp(speed, 1e-8, 1.0) * unit);
    std::vector<Estimate> values;
    for (const Prediction& each : predict(encounter, in_si, models)) {
      values.push_back(each.restitution);
      by_models = std::max(by_models, each.by_models);
      if (!(each.without_models.error <= options.error / 3.0)) {
        throw NotConverged("predict: at speed " + rounded(each.speed) + " m/s the computed channels do not converge");
      }
    }
    return values;
  };
  RestitutionFunction function = restitution_function(computed, slowest, fastest, options);
  return {std::move(function), by_models};
}

}  // namespace stoss
