#include "vibration_arguments.hpp"

#include <fmt/format.h>

#include <optional>

#include "keys.hpp"
#include "numbers.hpp"
#include "stoss/errors.hpp"
#include "text.hpp"

namespace stoss::cli {
namespace {

const std::vector<std::string> keys{"energy", "phase", "of"};
const std::vector<std::string> bodies{"first", "second"};

Oscillation parse_mode(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() < 3) {
    throw InvalidInput(
        fmt::format("mode: got '{}', allowed ORDER,INDEX,energy=SHARE and, after these, phase=PHI and "
                    "of=second",
                    shortened(text)));
  }
  Oscillation mode{.order = parse_integer("mode", parts[0]), .index = parse_integer("mode", parts[1])};
  std::optional<double> energy;
  for (const auto& [key, value] : parse_keys("mode", parts, 2, keys)) {
    if (key == "energy") energy = parse_number("mode energy", value);
    if (key == "phase") mode.phase = parse_number("mode phase", value);
    if (key != "of") continue;
    const std::string body = without_spaces(value);
    if (body != bodies[0] && body != bodies[1]) refuse_word("mode of", body, bodies);
    mode.body = body == bodies[0] ? 0 : 1;
  }
  if (!energy) throw InvalidInput(fmt::format("mode: got '{}', allowed a mode with its energy=SHARE", shortened(text)));
  mode.energy = *energy;
  return mode;
}

}  // namespace

void VibrationArguments::add_to(CLI::App& command) {
  command
      .add_option("--mode", modes,
                  "A mode that vibrates before the impact, once for each: order n and\n"
                  "index l as stoss modes has them; its energy, as a share of the\n"
                  "translational one; its phase in radians when bodies at rest inside\n"
                  "would touch (default: 0); of the second body with of=second")
      ->allow_extra_args(false)
      ->type_name("N,L,energy=SHARE[,phase=PHI][,of=second]")
      ->group("Vibration");
}

Vibration VibrationArguments::vibration() const {
  Vibration vibration;
  for (const std::string& text : modes) vibration.push_back(parse_mode(text));
  return vibration;
}

void VibrationArguments::describe(nlohmann::ordered_json& inputs) const {
  if (modes.empty()) return;
  auto list = nlohmann::ordered_json::array();
  for (const Oscillation& mode : vibration()) {
    list.push_back({{"body", bodies[static_cast<std::size_t>(mode.body)]},
                    {"order", mode.order},
                    {"index", mode.index},
                    {"energy", mode.energy},
                    {"phase", mode.phase}});
  }
  inputs["modes"] = std::move(list);
}

}  // namespace stoss::cli
