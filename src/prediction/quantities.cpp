#include "stoss/prediction/quantities.hpp"

#include <array>
#include <string>

#include "quantity_help.hpp"

namespace stoss {
namespace {

// In the order of Channel.
constexpr std::array<const char*, channel_names.size()> of_channels{
    "Share of the energy before that remains as vibration of the bodies",
    "Share of the energy before that waves in a block or a plate carry away",
    "Share of the energy before that becomes heat in the materials",
    "Share of the energy before that yielding takes",
    "Share of the energy before that adhesion takes",
};

}  // namespace

const Quantities<Prediction>& prediction_quantities() {
  using enum Dimension;
  static const Quantities<Prediction> all = [] {
    Quantities<Prediction> made{
        {"speed", Dimension::speed, help::speed, &Prediction::speed},
        {"restitution", none, "Coefficient of restitution with all channels, 0 where the bodies stick",
         &Prediction::restitution},
        {"by_models", none, "Spread of the models: distance of the farthest of them from the restitution",
         &Prediction::by_models},
        {"by_constants", none, "Change of the restitution by uncertain constants, root of the sum of squares",
         &Prediction::by_constants},
        {"models_low", none, "Lowest restitution of the models", &Prediction::models_low},
        {"models_high", none, "Highest restitution of the models", &Prediction::models_high},
        {"restitution_without_models", none,
         "Restitution without yield and adhesion, by waves and loss in the material alone",
         &Prediction::without_models},
    };
    for (std::size_t i = 0; i < channel_names.size(); ++i) {
      made.emplace_back(std::string(channel_names[i]), none, of_channels[i],
                        [i](const Prediction& of) { return of.shares[i]; });
    }
    made.emplace_back("dominant", none, "Channel that takes the most energy", [](const Prediction& of) {
      return std::string(channel_names[static_cast<std::size_t>(of.dominant)]);
    });
    made.emplace_back("drop_height", length, "Height from which a ball falls to this speed without air",
                      &Prediction::drop_height);
    made.emplace_back("rebound_height", length, "Height to which the ball rises after the impact without air",
                      &Prediction::rebound_height);
    made.emplace_back("contact_time", time, "Time from the first contact to the last, infinite where the bodies stick",
                      &Prediction::contact_time);
    return made;
  }();
  return all;
}

}  // namespace stoss
