#include "stoss/restitution/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "check.hpp"
#include "contact/unit_ratios.hpp"
#include "restitution/ladder/computed_pair.hpp"
#include "restitution/lasting.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr int level_count = 25;
constexpr int fewest_whole_levels = 3;  // for two runs, two levels apart

/// Levels below the highest one at which impacts with a body that is known at a point begin: the third is at that one.
constexpr int levels_of_a_point = 6;
constexpr int lowest_of_a_point = -40;

[[noreturn]] void refuse_missing_body() {
  throw InvalidInput::out_of_range("body", "no function that makes it", "one, such as disk(poisson)");
}

}  // namespace

struct RefinableContact::Ladder {
  BodyMaker body;
  Wall wall;                 // that it meets
  std::optional<Pair> pair;  // or two
  double unit = 1.0;         // of the cutoffs
  int highest = level_count - 1;
  std::mutex mutex;
  std::map<std::pair<double, double>, Contact> contacts;  // by cutoff and stretch
};

RefinableContact::RefinableContact(BodyMaker body) : RefinableContact(std::move(body), HardWall{}) {}

RefinableContact::RefinableContact(BodyMaker body, const Wall& wall) : ladder_(std::make_shared<Ladder>()) {
  if (!body) refuse_missing_body();
  validate(wall);
  ladder_->body = std::move(body);
  ladder_->wall = wall;
}

RefinableContact::RefinableContact(BodyMaker first, const BodyMaker& second) : ladder_(std::make_shared<Ladder>()) {
  if (!first) refuse_missing_body();
  ladder_->body = std::move(first);
  if (!second)
    throw InvalidInput::out_of_range("against", "no function that makes the body", "one, such as disk(poisson)");
  const Pair& pair = ladder_->pair.emplace(pair_of(ladder_->body, second));
  ladder_->unit = 1.0 / time_scale(pair.probe);
  const double most = pair_cutoff(pair) / ladder_->unit;
  while (ladder_->highest >= 0 && cutoff_at(ladder_->highest) > most) --ladder_->highest;
  if (ladder_->highest + 1 < fewest_levels) {
    refuse_unequal(*pair.probe.first, *pair.probe.second, most / cutoff_at(fewest_levels - 1), "");
  }
}

namespace {

/// Highest cutoff, in units of the first body, up to which bodies are known in a contact of a half-width.
double known_cutoff(const Contact& contact, double half_width, Directions directions) {
  const auto of = [half_width, directions](const Body& body, double length) {
    const double reach =
        directions == Directions::normal ? body.known.max_cutoff_times_width : body.known.max_cutoff_times_width_along;
    return std::min(body.known.complete_to, reach / (half_width / length));
  };
  const double first = of(*contact.first, 1.0);
  if (contact.second == nullptr) return first;
  const UnitRatios units(*contact.second, *contact.first);
  return std::min(first, of(*contact.second, units.length) / units.time);
}

/// Lowest frequency of the modes of bodies that are known at a point, in units of the first body; infinite without.
double first_mode(const Contact& contact) {
  double lowest = std::numeric_limits<double>::infinity();
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    if (body == nullptr || !is_known_at_a_point(*body)) continue;
    for (const ModeGroup& group : body->groups) {
      for (const double omega : group.omega) lowest = std::min(lowest, omega / units_of(contact, number).time);
    }
  }
  return lowest;
}

}  // namespace

int RefinableContact::highest_level() const { return ladder_->highest; }

int RefinableContact::highest_whole_level() const {
  if (!ladder_->pair || part() == 1.0) return highest_level();
  const double most = whole_cutoff(*ladder_->pair);
  int level = highest_level();
  while (level >= 0 && cutoff(level) > most) --level;
  if (level + 1 < fewest_whole_levels) {
    const Contact& probe = ladder_->pair->probe;
    refuse_unequal(*probe.first, *probe.second, most / cutoff(fewest_whole_levels - 1), "at an angle ");
  }
  return level;
}

int RefinableContact::highest_level(double stretch) const {
  int level = ladder_->highest;
  if (!ladder_->pair || !is_unbounded(*ladder_->pair->probe.second)) return level;
  const Body &first = *ladder_->pair->probe.first, &second = *ladder_->pair->probe.second;
  const double size = ladder_->pair->second_size * stretch, time = UnitRatios(second, first).time;
  const double most = second.near_side(size, least_cutoff, {}).highest_cutoff;
  while (level >= 0 && cutoff(level) * time > most) --level;
  if (level < 0) {
    throw NotConverged("restitution: a contact that may last " + shown(std::round(size * time)) +
                       " R/c needs more waves than are computed" +
                       (second.part.keeps_displacement ? " (it stays on so thin a plate)" : ""));
  }
  return level;
}

Levels RefinableContact::levels(double speed, double longer, const Poll& poll, Directions directions) const {
  Levels usable{0, highest_level(longer * stretch(speed))};
  const Contact& probe = at(0, poll);
  const double half_width = expected_half_width(probe, speed), most = known_cutoff(probe, half_width, directions);
  if (std::isinf(most)) return usable;
  while (usable.highest >= lowest_of_a_point && cutoff(usable.highest) > most) --usable.highest;
  // Beside a much softer one, modes are known to more than the contact needs: then it climbs as those of other bodies.
  usable.lowest = std::min(0, usable.highest - levels_of_a_point);
  // Without any mode the first impact tells nothing of the others: one level above, if that has one.
  const double first = first_mode(probe);
  if (usable.lowest < 0 && cutoff(usable.lowest) < first && first <= cutoff(usable.lowest + 1)) ++usable.lowest;
  if (usable.lowest < lowest_of_a_point) {
    throw NotConverged("'" + name(probe) + "': the contact would be some " +
                       rounded(std::round(1000.0 * half_width) / 1000.0) +
                       " R wide, wider than its modal data describe (use a lower speed; a body file with the "
                       "curvature of displacements reaches further)");
  }
  return usable;
}

double RefinableContact::cutoff(int level) const { return cutoff_at(level) * ladder_->unit; }

double RefinableContact::part() const {
  if (!ladder_->pair) return 1.0;
  const double second = is_unbounded(*ladder_->pair->probe.second) ? 1.0 : ladder_->pair->second_size;
  return std::min(ladder_->pair->first_size, second);
}

double RefinableContact::stretch(double speed) const {
  if (!ladder_->pair || !is_unbounded(*ladder_->pair->probe.second)) return 1.0;
  // In steps, so that the contacts of neighbouring speeds are the same.
  constexpr double margin = 1.05, steps = 4.0;
  const double wanted = std::max(1.0, margin * pair_duration(*ladder_->pair, speed) / shortest_contact);
  return std::exp2(std::ceil(steps * std::log2(wanted)) / steps);
}

const Contact& RefinableContact::at(int level, const Poll& poll) const {
  require("level", static_cast<long>(level), 0, highest_level(), "of refinement");
  return at(cutoff(level), 1.0, poll);
}

const Contact& RefinableContact::at(double cutoff, double stretch, const Poll& poll) const {
  const std::lock_guard lock(ladder_->mutex);
  const std::pair key(cutoff, stretch);
  const auto known = ladder_->contacts.find(key);
  if (known != ladder_->contacts.end()) return known->second;
  Contact contact = ladder_->pair ? pair_contact(*ladder_->pair, cutoff, stretch, poll)
                                  : stoss::contact(ladder_->body(cutoff, poll), ladder_->wall);
  return ladder_->contacts.emplace(key, std::move(contact)).first->second;
}

Contact contact(const BodyMaker& first, const BodyMaker& second, double cutoff, double slowest, const Poll& poll) {
  const Pair pair = pair_of(first, second);
  if (is_unbounded(*pair.probe.second)) {
    constexpr double margin = 1.25;
    const RefinableContact refinable(first, second);
    const double expected = std::max(1.0, margin * pair_duration(pair, slowest) / shortest_contact);
    const double lasting = lasting_stretch(refinable, slowest, poll);
    const double stretch = lasting > refinable.stretch(slowest) ? std::max(expected, lasting) : expected;
    const Body& met = *pair.probe.second;
    const double most = met.near_side(pair.second_size * stretch, least_cutoff, poll).highest_cutoff /
                        UnitRatios(met, *pair.probe.first).time;
    constexpr std::string_view why = "in c/R of the first body; contacts that last so long meet too many waves above";
    require("cutoff", cutoff, {0.0, most, false, true, "above 0 to " + shown_most(most)}, why);
    try {
      return pair_contact(pair, cutoff, stretch, poll);
    } catch (const InvalidInput& error) {  // of a lossy one, in its own units
      if (error.name() != "cutoff") throw;
      throw InvalidInput::out_of_range("cutoff", shown(cutoff), "a lower one", std::string(why));
    }
  }
  const double most = pair_cutoff(pair);
  if (pair.first_size == 1.0 && pair.second_size == 1.0) {
    const Body& met = *pair.probe.second;
    const double of_second = met.highest_cutoff / UnitRatios(met, *pair.probe.first).time;
    constexpr double rounding = 1.0 + 1e-9;
    if (cutoff > rounding * of_second) {
      require("cutoff", cutoff, {0.0, of_second, false, true, "above 0 to " + shown_most(of_second)},
              "highest frequency in c/R of the first body; above, the second has more modes than are computed");
    }
    return pair_contact(pair, cutoff, 1.0, poll);
  }
  constexpr double smallest = 0.5;
  constexpr double none = std::numeric_limits<double>::min();
  require("cutoff", cutoff, {none, most / smallest, true, true, "above 0 to " + shown_most(most / smallest)},
          "highest frequency in c/R of the first body; the larger one has more modes than are computed");
  return pair_contact(pair, cutoff, std::min(1.0, most / cutoff), poll);
}

}  // namespace stoss
