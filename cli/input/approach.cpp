#include "input/approach.hpp"

#include "input/encounter.hpp"
#include "process/text.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"
#include "stoss/prediction/prediction.hpp"

namespace stoss::cli {

void ApproachOptions::add_to(CLI::App& command, Question of, const std::string& group) {
  question = of;
  CLI::Option* of_speed = add_input(command, of, "speed", speed, group);
  add_input(command, of, "height", height, group)->excludes(of_speed);
}

void ApproachOptions::require_given(const Units& units) const {
  if (speed.empty() && height.empty()) throw CLI::RequiredError("--speed or --height");
  if (!height.empty() && !units.si) {
    throw InvalidInput::conflict("height", "needs a body with a material", "or give --speed in c of the body");
  }
}

std::vector<double> ApproachOptions::series(const Units& units) const {
  require_given(units);
  if (height.empty()) return series_of(question, "speed", speed, units);
  std::vector<double> speeds = series_of(question, "height", height, units);
  for (double& each : speeds) {
    each = in_own_units(input(question, "speed"), speed_of_drop(each), units.si, units.in_si);
  }
  return speeds;
}

double ApproachOptions::one(const Units& units, const std::string& note) const {
  const std::vector<double> speeds = series(units);
  if (speeds.size() == 1) return speeds.front();
  throw InvalidInput::out_of_range(height.empty() ? "speed" : "height", fmt::format("{} numbers", speeds.size()), "one",
                                   note);
}

Ends ApproachOptions::ends(const Units& units) const {
  require_given(units);
  if (height.empty()) return ends_of(question, "speed", speed, units);
  const Ends heights = ends_of(question, "height", height, units);
  const auto own = [&](double of) { return in_own_units(input(question, "speed"), of, units.si, units.in_si); };
  const double slowest = speed_of_drop(heights.typed.first), fastest = speed_of_drop(heights.typed.second);
  return {{slowest, fastest}, {own(slowest), own(fastest)}};
}

}  // namespace stoss::cli
