#include "stoss/impact/vibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "check.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/free_flight.hpp"
#include "impact/inputs.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// A mode of a contact.
struct Place {
  std::size_t group, index;
  int body, order, number;
};

/// All modes, in their order.
std::vector<Place> places(const Contact& contact) {
  std::vector<Place> all;
  for (std::size_t g = 0; g < contact.groups.size(); ++g) {
    const ModeGroup& group = contact.groups[g];
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const int number = group.index.empty() ? static_cast<int>(l) : group.index[l];
      all.push_back({g, l, g < contact.first_groups ? 0 : 1, group.order, number});
    }
  }
  return all;
}

/// Their numbers in that order, by body, order and index.
class Numbers {
 public:
  explicit Numbers(const std::vector<Place>& all) {
    for (std::size_t k = 0; k < all.size(); ++k) sorted_.push_back({{all[k].body, all[k].order, all[k].number}, k});
    if (!std::is_sorted(sorted_.begin(), sorted_.end())) std::sort(sorted_.begin(), sorted_.end());
  }

  [[nodiscard]] std::optional<std::size_t> of(const Oscillation& mode) const {
    const Key key{mode.body, mode.order, mode.index};
    const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(key, std::size_t{0}));
    return at != sorted_.end() && at->first == key ? std::optional(at->second) : std::nullopt;
  }

 private:
  using Key = std::tuple<int, int, int>;
  std::vector<std::pair<Key, std::size_t>> sorted_;
};

void require_motion(const State& state) {
  if (!(state.velocity != 0.0) || !std::isfinite(state.velocity)) {
    throw InvalidInput::out_of_range("state", "velocity " + shown(state.velocity), "bodies that move");
  }
}

}  // namespace

State approach(const Contact& contact, double speed, const Vibration& vibration) {
  require_speed(speed);
  const std::size_t count = mode_count(contact);
  State state{-contact.extent, speed, std::vector<double>(count), std::vector<double>(count)};
  const std::vector<Place> all = places(contact);
  const Numbers numbers(all);
  std::vector<bool> given(count);
  const double translation = 0.5 * contact.mass * speed * speed;
  const auto set = [&](std::size_t k, double energy, double phase) {
    const double omega = contact.groups[all[k].group].omega[all[k].index];
    const double mass = modal_mass(contact, all[k].group), momentum = std::sqrt(2.0 * mass * energy * translation);
    state.coordinate[k] = momentum / (mass * omega) * std::cos(phase);
    state.momentum[k] = -momentum * std::sin(phase);
  };
  std::vector<std::size_t> found;
  for (const Oscillation& mode : vibration) {
    require_possible(contact, mode);
    const std::optional<std::size_t> at = numbers.of(mode);
    if (!at) {
      throw InvalidInput::out_of_range("vibration", named(mode),
                                       "modes up to the cutoff, " + shown_most(contact.cutoff), "raise it");
    }
    if (given[*at]) throw InvalidInput::out_of_range("vibration", named(mode) + " twice", "once");
    constexpr Range not_negative{0.0, 1e12, true, true, "0 to 1e12"};
    require("energy", mode.energy, not_negative, "of a mode, as a share of the translational energy");
    require("phase", mode.phase, {-1e12, 1e12, true, true, "-1e12 to 1e12"}, "of a mode, radians");
    given[*at] = true;
    found.push_back(*at);
    set(*at, mode.energy, mode.phase);
  }
  const double time = time_before_touch(contact, state), distance = time * speed;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Place& place = all[found[i]];
    set(found[i], vibration[i].energy, vibration[i].phase - contact.groups[place.group].omega[place.index] * time);
  }
  state.center -= distance;
  return state;
}

Vibration vibration(const Contact& contact, const State& state) {
  const std::vector<double> energies = mode_energies(contact, state);
  require_motion(state);
  const double translation = 0.5 * contact.mass * state.velocity * state.velocity;
  const double time = -(state.center + contact.extent) / state.velocity;  // until they would touch
  const std::vector<Place> all = places(contact);
  Vibration result;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (energies[k] == 0.0) continue;
    const double omega = contact.groups[all[k].group].omega[all[k].index];
    const double restoring = modal_mass(contact, all[k].group) * omega * state.coordinate[k];
    const double phase = std::atan2(-state.momentum[k], restoring) + omega * time;
    result.push_back({all[k].body, all[k].order, all[k].number, energies[k] / translation,
                      std::remainder(phase, 2.0 * std::numbers::pi)});
  }
  return result;
}

Vibration vibration_after(const Contact& contact, const State& state, double flight) {
  require("flight", flight, {0.0, 1e12, true, true, "0 to 1e12"}, "R/c, from one impact to the next");
  (void)mode_energies(contact, state);  // refuses a state of another number of modes
  require_motion(state);
  // Back to the nominal touch is no further than a lossy body has flown.
  State next = free_motion(contact, state, flight - (state.center + contact.extent) / state.velocity);
  next.center = -contact.extent;
  Vibration all = vibration(contact, next);
  std::erase_if(all, [&](const Oscillation& mode) { return !is_whole(*body_of(contact, mode.body)); });
  return all;
}

bool keeps(const Contact& contact, const Vibration& vibration) {
  const Numbers numbers(places(contact));
  return std::all_of(vibration.begin(), vibration.end(), [&](const Oscillation& mode) {
    require_possible(contact, mode);
    return numbers.of(mode).has_value();
  });
}

}  // namespace stoss
