#include "stoss/restitution/ladder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>
#include <utility>

#include "check.hpp"
#include "contact/units.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Below the modes of all bodies: at this cutoff one can be asked what it is by itself.
constexpr double least_cutoff = 1e-6;

constexpr int levels = 25;
constexpr int fewest_levels = 10;  // for an error

double cutoff_at(int level) { return 4.0 * std::numbers::sqrt2 * std::exp2(0.25 * level); }

/// What meets, without modes.
Contact probed(const BodyMaker& first, const BodyMaker& second) {
  Body one = first(least_cutoff, {});
  const Units units(second(least_cutoff, {}), one);
  return contact(std::move(one), second(least_cutoff * units.time, {}));
}

}  // namespace

struct RefinableContact::Levels {
  BodyMaker first, second;
  double unit = 1.0;  // of the cutoffs
  int highest = levels - 1;
  std::mutex mutex;
  std::array<std::optional<Contact>, levels> contacts;
};

RefinableContact::RefinableContact(BodyMaker body) : levels_(std::make_shared<Levels>()) {
  if (!body) throw InvalidInput("body: got no function that makes it, allowed one, such as disk(poisson)");
  levels_->first = std::move(body);
}

RefinableContact::RefinableContact(BodyMaker first, BodyMaker second) : RefinableContact(std::move(first)) {
  if (!second) throw InvalidInput("against: got no function that makes the body, allowed one, such as disk(poisson)");
  const Contact probe = probed(levels_->first, second);
  const Body &one = *probe.first, &other = *probe.second;
  levels_->unit = 1.0 / time_scale(probe);
  const double most = std::min(one.highest_cutoff, other.highest_cutoff / Units(other, one).time) / levels_->unit;
  while (levels_->highest >= 0 && cutoff_at(levels_->highest) > most) --levels_->highest;
  if (levels_->highest + 1 < fewest_levels) {
    throw InvalidInput(
        "against: got '" + other.name + "' for '" + one.name +
        "', allowed a body whose R/c is up to some 50 times that of the other (more modes than are computed)");
  }
  levels_->second = std::move(second);
}

int RefinableContact::highest_level() const { return levels_->highest; }

double RefinableContact::cutoff(int level) const { return cutoff_at(level) * levels_->unit; }

const Contact& RefinableContact::at(int level, const Poll& poll) const {
  require("level", static_cast<long>(level), 0, highest_level(), "of refinement");
  const std::lock_guard lock(levels_->mutex);
  std::optional<Contact>& made = levels_->contacts[static_cast<std::size_t>(level)];
  if (!made) {
    made = levels_->second ? contact(levels_->first, levels_->second, cutoff(level), poll)
                           : contact(levels_->first(cutoff(level), poll));
  }
  return *made;
}

Contact contact(const BodyMaker& first, const BodyMaker& second, double cutoff, const Poll& poll) {
  const Contact probe = probed(first, second);
  return contact(first(cutoff, poll), second(cutoff * Units(*probe.second, *probe.first).time, poll));
}

}  // namespace stoss
