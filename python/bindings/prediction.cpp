// What a drop test of real balls shows: predictions, and where their models begin to matter.
#include "stoss/prediction/prediction.hpp"

#include <map>
#include <optional>
#include <string>

#include "stoss/prediction/quantities.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

py::dict described(const Prediction& prediction) {
  py::dict dict = to_dict(prediction_quantities(), prediction);
  py::list influences;
  for (const auto& [constant, uncertainty, change] : prediction.influences) {
    influences.append(py::make_tuple(constant, uncertainty, change));
  }
  dict["influences"] = influences;
  dict["warnings"] = prediction.warnings;
  return dict;
}

py::list predictions(const Encounter& encounter, const Doubles& speeds, std::optional<double> adhesion,
                     const std::map<std::string, double>& uncertainties, double tolerance, int threads) {
  const std::vector<double> at = to_vector(speeds);
  PredictionOptions options{.work_of_adhesion = adhesion,
                            .uncertainties = {uncertainties.begin(), uncertainties.end()},
                            .tolerance = tolerance,
                            .threads = threads};
  const std::vector<Prediction> all = computed([&](const Poll& poll) {
    options.poll = poll;
    return predict(encounter, at, options);
  });
  py::list made;
  for (const Prediction& each : all) made.append(described(each));
  return made;
}

}  // namespace

void bind_prediction(py::module_& module) {
  bind_over(module, "speed_of_drop", &speed_of_drop, "heights");
  def(module, "predict", {"encounter", "speeds", "adhesion", "uncertainties", "tolerance", "threads"}, &predictions);
  def(module, "thresholds", {"encounter", "adhesion"}, [](const Encounter& encounter, std::optional<double> adhesion) {
    const Thresholds made = thresholds(encounter, {.work_of_adhesion = adhesion});
    return py::make_tuple(made.yield, made.impression, made.sticking, made.adhesion, made.rough);
  });
}

}  // namespace stoss::python
