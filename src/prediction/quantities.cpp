#include "stoss/prediction/quantities.hpp"

#include <string>

namespace stoss {

const Quantities<Prediction>& prediction_quantities() {
  using enum Dimension;
  static const Quantities<Prediction> all = [] {
    Quantities<Prediction> made{
        {"speed", Dimension::speed, &Prediction::speed},
        {"restitution", none, &Prediction::restitution},
        {"by_models", none, &Prediction::by_models},
        {"by_constants", none, &Prediction::by_constants},
        {"models_low", none, &Prediction::models_low},
        {"models_high", none, &Prediction::models_high},
        {"restitution_without_models", none, &Prediction::without_models},
    };
    for (std::size_t i = 0; i < channel_names.size(); ++i) {
      made.emplace_back(std::string(channel_names[i]), none, [i](const Prediction& of) { return of.shares[i]; });
    }
    made.emplace_back("dominant", none, [](const Prediction& of) {
      return std::string(channel_names[static_cast<std::size_t>(of.dominant)]);
    });
    made.emplace_back("drop_height", length, &Prediction::drop_height);
    made.emplace_back("rebound_height", length, &Prediction::rebound_height);
    made.emplace_back("contact_time", time, &Prediction::contact_time);
    return made;
  }();
  return all;
}

}  // namespace stoss
