#include "input/encounter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

#include "app.hpp"
#include "input/inputs.hpp"
#include "process/process.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

const std::vector<std::string> bodies{"first", "second"};

/// Of --mode or --spectrum. @param keys that may stand behind order and index
Oscillation parse_mode(const std::string& option, const std::vector<std::string>& keys, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  const std::string allowed =
      fmt::format("ORDER,INDEX,energy=SHARE, also with {}", fmt::join(keys.begin() + 1, keys.end(), ", "));
  if (parts.size() < 3) throw InvalidInput::out_of_range(option, fmt::format("'{}'", shortened(text)), allowed);
  Oscillation mode{.order = parse_integer(option, parts[0]), .index = parse_integer(option, parts[1])};
  std::optional<double> energy;
  for (const auto& [key, value] : parse_keys(option, parts, 2, keys)) {
    if (key == "energy") energy = parse_number(option + " energy", value);
    if (key == "body") mode.body = parse_integer(option + " body", value);
    if (key == "phase") mode.phase = parse_number(option + " phase", value);
    if (key != "of") continue;
    const std::string body = without_spaces(value);
    if (body != bodies[0] && body != bodies[1]) refuse_word(option + " of", body, bodies);
    mode.body = body == bodies[0] ? 0 : 1;
  }
  if (!energy) {
    throw InvalidInput::out_of_range(option, fmt::format("'{}' without energy", shortened(text)), allowed);
  }
  mode.energy = *energy;
  return mode;
}

Vibration parse_modes(const std::string& option, const std::vector<std::string>& keys,
                      const std::vector<std::string>& texts) {
  Vibration modes;
  for (const std::string& text : texts) modes.push_back(parse_mode(option, keys, text));
  return modes;
}

}  // namespace

void add_modes_to(CLI::App& command, std::vector<std::string>& modes) {
  add(command, "--mode", modes,
      "A mode that vibrates before the impact, once for each: order n and\n"
      "index l as stoss modes has them, its energy as a share of the\n"
      "translational one, and its phase in radians when unexcited bodies\n"
      "would touch (default: 0); of the second body with of=second",
      "N,L,energy=SHARE[,phase=PHI][,of=second]", "Vibration");
}

Vibration vibration_of(const std::vector<std::string>& modes) {
  return parse_modes("mode", {"energy", "phase", "of"}, modes);
}

void add_modes_of_row_to(CLI::App& command, std::vector<std::string>& modes) {
  add(command, "--mode", modes,
      "A mode that vibrates before, once for each: order n and index l as\n"
      "stoss modes has them, its energy as a share of that of all centres,\n"
      "its phase in radians at the start (default: 0), and the number of the\n"
      "body from the left, from 0 (default: 0)",
      "N,L,energy=SHARE[,phase=PHI][,body=NUMBER]", "Vibration");
}

Vibration vibration_of_row(const std::vector<std::string>& modes) {
  return parse_modes("mode", {"energy", "phase", "body"}, modes);
}

Vibration SpectrumArguments::means() const { return parse_modes("spectrum", {"energy", "of"}, modes); }

void SpectrumArguments::add_to(CLI::App& command) {
  add_input(command, Question::distribution, "temperature", temperature, "Vibration");
  add_input(command, Question::distribution, "highest", highest, "Vibration");
  add(command, "--spectrum", modes,
      "A mode that vibrates, once for each: order n and index l as stoss\n"
      "modes has them, and its mean energy as a share of the translational\n"
      "one, 0 to 1e6; of the second body with of=second",
      "N,L,energy=SHARE[,of=second]", "Vibration");
}

Spectrum SpectrumArguments::spectrum(const RefinableContact& contact, const Poll& poll) {
  if (temperature.has_value() != modes.empty()) {
    throw InvalidInput::out_of_range("temperature",
                                     fmt::format("{} --temperature and --spectrum", temperature ? "both" : "neither"),
                                     "one of the two");
  }
  if (highest && !temperature) {
    throw InvalidInput::out_of_range("highest", "--highest with --spectrum", "only with --temperature");
  }
  if (temperature) {
    if (!highest) highest = usual_highest(contact, poll);
    return thermal(contact, *temperature, *highest, poll);
  }
  Spectrum spectrum;
  for (const Oscillation& mean : means()) spectrum.push_back({mean.body, mean.order, mean.index, mean.energy});
  return spectrum;
}

void SpectrumArguments::describe(nlohmann::ordered_json& inputs) const {
  if (highest) inputs["highest"] = *highest;
  if (!modes.empty()) inputs["spectrum"] = modes;
}

}  // namespace stoss::cli
