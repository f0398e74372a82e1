#include "stoss/restitution/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "check.hpp"
#include "contact/units.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Below the modes of all bodies: at this cutoff one can be asked what it is by itself.
constexpr double least_cutoff = 1e-6;

constexpr int levels = 23;
constexpr int fewest_levels = 8;  // for an error

double cutoff_at(int level) { return 8.0 * std::exp2(0.25 * level); }

/// The near side of a body stands for it from this size on, in what its waves travel within time_scale: from there on
/// it is computed faster than the whole, to a tolerance of 1e-3.
constexpr double largest_whole = 24.0;

/// Size of the part that does. Waves are back from its far side after some 45 times time_scale; a contact lasts 6 to 10
/// at v = 0.1, and 20 at 1e-8.
constexpr double part_size = 12.0;

/// Two bodies that meet.
struct Pair {
  BodyMaker first, second;
  Contact probe;                               // without modes
  double first_size = 1.0, second_size = 1.0;  // of the parts that are computed
};

Contact probed(const BodyMaker& first, const BodyMaker& second) {
  Body one = first(least_cutoff, {});
  const Units units(second(least_cutoff, {}), one);
  return contact(std::move(one), second(least_cutoff * units.time, {}));
}

double computed_size(const Body& body, double transit) {
  return body.near_side && transit > largest_whole ? part_size / transit : 1.0;
}

Pair pair_of(const BodyMaker& first, const BodyMaker& second) {
  Pair pair{first, second, probed(first, second)};
  const double unit = time_scale(pair.probe);
  pair.first_size = computed_size(*pair.probe.first, 1.0 / unit);
  pair.second_size = computed_size(*pair.probe.second, Units(*pair.probe.second, *pair.probe.first).time / unit);
  return pair;
}

/// The part of a body, or the body.
Body made(const BodyMaker& maker, const Body& probe, double size, double cutoff, const Poll& poll) {
  return size < 1.0 ? probe.near_side(size, cutoff, poll) : maker(cutoff, poll);
}

/// @param stretch of the part, where there is one; it ends with the whole
Contact contact_of(const Pair& pair, double cutoff, double stretch, const Poll& poll) {
  const auto size = [stretch](double usual) { return usual < 1.0 ? std::min(usual * stretch, 1.0) : 1.0; };
  const double time = Units(*pair.probe.second, *pair.probe.first).time;
  return contact(made(pair.first, *pair.probe.first, size(pair.first_size), cutoff, poll),
                 made(pair.second, *pair.probe.second, size(pair.second_size), cutoff * time, poll));
}

/// Highest cutoff of both bodies, c/R of the first.
double highest_cutoff(const Pair& pair) {
  const Body &one = *pair.probe.first, &other = *pair.probe.second;
  return std::min(one.highest_cutoff / pair.first_size,
                  other.highest_cutoff / pair.second_size / Units(other, one).time);
}

}  // namespace

struct RefinableContact::Levels {
  BodyMaker body;            // at a wall
  std::optional<Pair> pair;  // or two
  double unit = 1.0;         // of the cutoffs
  int highest = levels - 1;
  std::mutex mutex;
  std::map<std::pair<double, double>, Contact> contacts;  // by cutoff and stretch
};

RefinableContact::RefinableContact(BodyMaker body) : levels_(std::make_shared<Levels>()) {
  if (!body) throw InvalidInput("body: got no function that makes it, allowed one, such as disk(poisson)");
  levels_->body = std::move(body);
}

RefinableContact::RefinableContact(BodyMaker first, BodyMaker second) : RefinableContact(std::move(first)) {
  if (!second) throw InvalidInput("against: got no function that makes the body, allowed one, such as disk(poisson)");
  const Pair& pair = levels_->pair.emplace(pair_of(levels_->body, second));
  levels_->unit = 1.0 / time_scale(pair.probe);
  const double most = highest_cutoff(pair) / levels_->unit;
  while (levels_->highest >= 0 && cutoff_at(levels_->highest) > most) --levels_->highest;
  if (levels_->highest + 1 < fewest_levels) {
    throw InvalidInput("against: got '" + pair.probe.second->name + "' for '" + pair.probe.first->name +
                       "', allowed a body whose R/c is up to some 50 times that of the other (more modes than are "
                       "computed)");
  }
}

int RefinableContact::highest_level() const { return levels_->highest; }

double RefinableContact::cutoff(int level) const { return cutoff_at(level) * levels_->unit; }

double RefinableContact::part() const {
  return levels_->pair ? std::min(levels_->pair->first_size, levels_->pair->second_size) : 1.0;
}

const Contact& RefinableContact::at(int level, const Poll& poll) const {
  require("level", static_cast<long>(level), 0, highest_level(), "of refinement");
  return at(cutoff(level), 1.0, poll);
}

const Contact& RefinableContact::at(double cutoff, double stretch, const Poll& poll) const {
  const std::lock_guard lock(levels_->mutex);
  const std::pair key(cutoff, stretch);
  const auto known = levels_->contacts.find(key);
  if (known != levels_->contacts.end()) return known->second;
  Contact contact =
      levels_->pair ? contact_of(*levels_->pair, cutoff, stretch, poll) : stoss::contact(levels_->body(cutoff, poll));
  return levels_->contacts.emplace(key, std::move(contact)).first->second;
}

Contact contact(const BodyMaker& first, const BodyMaker& second, double cutoff, const Poll& poll) {
  return contact_of(pair_of(first, second), cutoff, 1.0, poll);
}

}  // namespace stoss
