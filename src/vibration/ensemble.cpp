// E = −⟨E⟩ ln u₁, φ = 2π u₂: the polar form of two normal numbers √(2E) cos φ, −√(2E) sin φ (Box and Muller 1958).
#include "stoss/vibration/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include "check.hpp"
#include "numeric/random.hpp"
#include "restitution/own_choice.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Levels of the ladder above the modes that vibrate, for `restitution` to have three cutoffs.
constexpr int levels_above = 6;

/// Whether a body is there, and known, as a whole, and deforms.
bool can_vibrate(const Body& body) { return is_whole(body) && !is_known_at_a_point(body) && body.softness > 0.0; }

/// What may be asked for as the highest frequency of a thermal spectrum, level by level.
class Allowed {
 public:
  Allowed(const RefinableContact& contact, const Poll& poll)
      : contact_(contact), poll_(poll), loss_(longest_loss_time(contact.at(0, poll))) {
    const Contact& probe = contact.at(0, poll);
    if (!can_vibrate(*probe.first) && (probe.second == nullptr || !can_vibrate(*probe.second))) {
      throw InvalidInput::out_of_range("temperature", "bodies without modes that vibrate", "bodies that have some",
                                       "no rigid body, nothing without end, and nothing that is known at a point only");
    }
  }

  /// What meets a body that is known at a point only vibrates as high as that is known, in a slow impact.
  [[nodiscard]] double greatest() const {
    constexpr double slowest = 1e-8;
    const double usual = kept(std::max(0, contact_.highest_level() - levels_above));
    const Contact& probe = contact_.at(0, poll_);
    const bool known = !is_known_at_a_point(*probe.first) && !(probe.second && is_known_at_a_point(*probe.second));
    return known ? usual : std::min(usual, kept(contact_.levels(slowest, 1.0, poll_).lowest));
  }

  /// With all modes up to a frequency, and perhaps more.
  [[nodiscard]] const Contact& with(double highest) const {
    int level = 0;
    while (kept(level) < highest) ++level;
    return contact_.at(level, poll_);
  }

 private:
  [[nodiscard]] double kept(int level) const { return kept_cutoff(contact_.cutoff(level), loss_); }

  const RefinableContact& contact_;
  const Poll& poll_;
  double loss_;
};

void for_each_mode(const Contact& contact,
                   const std::function<void(int body, const ModeGroup& group, std::size_t l)>& visit) {
  for (std::size_t g = 0; g < contact.groups.size(); ++g) {
    const int number = g < contact.first_groups ? 0 : 1;
    const Body& body = number == 0 ? *contact.first : *contact.second;
    if (!can_vibrate(body)) continue;
    for (std::size_t l = 0; l < contact.groups[g].omega.size(); ++l) visit(number, contact.groups[g], l);
  }
}

/// Infinite where there is none.
double lowest_mode(const Contact& contact) {
  double lowest = std::numeric_limits<double>::infinity();
  for_each_mode(contact,
                [&lowest](int, const ModeGroup& group, std::size_t l) { lowest = std::min(lowest, group.omega[l]); });
  return lowest;
}

}  // namespace

double usual_highest(const RefinableContact& contact, const Poll& poll) {
  constexpr double usual = 10.0;
  return of_own_choice([&] {
    const Allowed allowed(contact, poll);
    const double greatest = allowed.greatest();
    if (greatest <= usual || lowest_mode(allowed.with(usual)) <= usual) return std::min(usual, greatest);
    const double lowest = lowest_mode(allowed.with(greatest));
    return lowest <= greatest ? lowest : greatest;
  });
}

Spectrum thermal(const RefinableContact& contact, double temperature, double highest, const Poll& poll) {
  require("temperature", temperature, ranges::energy, "k_B T over the translational energy");
  const Allowed allowed(contact, poll);
  const double greatest = allowed.greatest();
  require("highest", highest, {0.0, greatest, false, true, "above 0 to " + shown_most(greatest)},
          "frequency up to which modes vibrate, in c/R of the first body");
  Spectrum spectrum;
  const Contact& resolved = of_own_choice([&]() -> const Contact& { return allowed.with(highest); });
  for_each_mode(resolved, [&](int body, const ModeGroup& group, std::size_t l) {
    const int index = group.index.empty() ? static_cast<int>(l) : group.index[l];
    if (group.omega[l] <= highest) spectrum.push_back({body, group.order, index, temperature});
  });
  if (!spectrum.empty()) return spectrum;
  const double lowest = lowest_mode(allowed.with(greatest));
  if (lowest > greatest) {
    throw InvalidInput::out_of_range("temperature",
                                     "bodies without modes that vibrate up to " + shown_most(greatest) + " c/R",
                                     "bodies that have some");
  }
  throw InvalidInput::out_of_range("highest", shown(highest),
                                   "from " + shown_least(lowest) + ", the lowest mode, to " + shown_most(greatest));
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
    require("energy", mode.energy, ranges::energy, "mean of a mode, as a share of the translational energy");
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
