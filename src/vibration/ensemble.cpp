// E = −⟨E⟩ ln u₁, φ = 2π u₂: the polar form of two normal numbers √(2E) cos φ, −√(2E) sin φ (Box and Muller 1958).
#include "stoss/vibration/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include "check.hpp"
#include "numeric/random.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr Range energies{0.0, 1e6, true, true, "0 to 1e6"};

/// Levels of the ladder above the modes that vibrate, for `restitution` to have three cutoffs.
constexpr int levels_above = 6;

}  // namespace

Spectrum thermal(const RefinableContact& contact, double temperature, double highest, const Poll& poll) {
  require("temperature", temperature, energies, "k_B T over the translational energy");
  const double loss = longest_loss_time(contact.at(0, poll));
  const auto kept = [&](int level) { return kept_cutoff(contact.cutoff(level), loss); };
  const int top = std::max(0, contact.highest_level() - levels_above);
  require("highest", highest, {0.0, kept(top), false, true, "above 0 to " + shown(kept(top))},
          "frequency up to which modes vibrate, in c/R of the first body; 10 where none is given");
  int level = 0;
  while (kept(level) < highest) ++level;

  const Contact& resolved = contact.at(level, poll);
  Spectrum spectrum;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < resolved.groups.size(); ++g) {
    const bool second = g >= resolved.first_groups;
    if (!is_whole(second ? *resolved.second : *resolved.first)) continue;
    const ModeGroup& group = resolved.groups[g];
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      lowest = std::min(lowest, group.omega[l]);
      if (group.omega[l] > highest) continue;
      const int index = group.index.empty() ? static_cast<int>(l) : group.index[l];
      spectrum.push_back({second ? 1 : 0, group.order, index, temperature});
    }
  }
  if (spectrum.empty()) {
    throw InvalidInput("highest: got " + shown(highest) + ", allowed " +
                       (std::isfinite(lowest) ? "from " + shown(lowest) + ", the lowest mode, to " + shown(kept(top))
                                              : "bodies that have modes at such frequencies"));
  }
  return spectrum;
}

std::vector<double> frequencies(const RefinableContact& contact, const Spectrum& spectrum, const Poll& poll) {
  Vibration named;
  for (const MeanEnergy& mode : spectrum) named.push_back({mode.body, mode.order, mode.index});
  int level = 0;
  while (!keeps(contact.at(level, poll), named)) ++level;
  const Contact& resolved = contact.at(level, poll);
  std::map<std::tuple<int, int, int>, double> omega;
  for (std::size_t g = 0; g < resolved.groups.size(); ++g) {
    const ModeGroup& group = resolved.groups[g];
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const int index = group.index.empty() ? static_cast<int>(l) : group.index[l];
      omega.emplace(std::tuple(g < resolved.first_groups ? 0 : 1, group.order, index), group.omega[l]);
    }
  }
  std::vector<double> all;
  for (const MeanEnergy& mode : spectrum) all.push_back(omega.at({mode.body, mode.order, mode.index}));
  return all;
}

Vibration draw(const Spectrum& spectrum, std::uint64_t seed, std::uint64_t sample) {
  Vibration vibration;
  vibration.reserve(spectrum.size());
  for (const MeanEnergy& mode : spectrum) {
    require("energy", mode.energy, energies, "mean of a mode, as a share of the translational energy");
    if (mode.energy == 0.0) continue;
    // One counter for each mode of each body in each sample.
    const auto body_and_order = static_cast<std::uint32_t>(mode.body) << 31U | static_cast<std::uint32_t>(mode.order);
    const auto [first, second] =
        numeric::uniform(seed, {static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(sample >> 32U),
                                body_and_order, static_cast<std::uint32_t>(mode.index)});
    vibration.push_back(
        {mode.body, mode.order, mode.index, -mode.energy * std::log(first), 2.0 * std::numbers::pi * second});
  }
  return vibration;
}

}  // namespace stoss
