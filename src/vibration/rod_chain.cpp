// Rods on a ring keep their order, so every pair of neighbours has its own gap g and next collision: t + g/(v_k −
// v_k+1).
#include "stoss/vibration/rod_chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "vibration/rod_vibrations.hpp"

namespace stoss {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

void validate(const std::vector<Rod>& rods, double circumference, const std::vector<double>& velocities,
              const RodChainOptions& options) {
  require("rods", static_cast<long>(rods.size()), 2, 100'000, "number of rods in the chain");
  double length = 0.0;
  for (const Rod& rod : rods) {
    static_cast<void>(scales(rod));  // refuses what is out of range
    if (rod.loss_time != 0.0) {
      throw InvalidInput::out_of_range("loss_time", shown(rod.loss_time) + " for a rod of a chain", "0",
                                       "decay_time damps all vibrations alike");
    }
    length += rod.length;
  }
  require("circumference", circumference,
          {length, std::numeric_limits<double>::max(), false, true, "above the sum of the lengths"}, "of the ring");
  if (velocities.size() != rods.size()) {
    throw InvalidInput::out_of_range("velocities", std::to_string(velocities.size()), std::to_string(rods.size()),
                                     "one for each rod");
  }
  constexpr Range speeds{-1e100, 1e100, true, true, "-1e100 to 1e100"};
  for (const double each : velocities) require("velocities", each, speeds, "of the rods");
  require("modes", static_cast<long>(options.modes), 1, 10'000, "kept modes of the rod of the shortest transit time");
  require("pieces", static_cast<long>(options.pieces), 2, 1'000'000, "of the wave in a rod");
  if (options.decay_time) {
    require("decay_time", *options.decay_time, {0.0, std::numeric_limits<double>::max(), true, true, "0 or more"},
            "of the energy of vibrations");
  }
}

}  // namespace

struct RodChain::State {
  struct Member {
    double mass, velocity;  // in the frame of the centre of mass
    double seen = 0.0;      // time of its vibration
  };
  struct Pair {
    double gap, seen = 0.0, next = never;  // at the time `seen`
  };

  std::vector<Member> rods{};
  std::vector<Pair> pairs{};  // of each rod and its right neighbour
  std::unique_ptr<RodVibrations> vibrations{};
  std::optional<double> decay_time{};
  double drift = 0.0;  // of the centre of mass
  double time = 0.0, dissipated = 0.0, unresolved = 0.0;
  long collisions = 0;
  double crowded_since = 0.0;  // collapse: the collisions since a time that has hardly changed
  long crowded = 0;

  [[nodiscard]] std::size_t right_of(std::size_t rod) const { return rod + 1 == rods.size() ? 0 : rod + 1; }
  [[nodiscard]] double closing(std::size_t pair) const { return rods[pair].velocity - rods[right_of(pair)].velocity; }

  [[nodiscard]] double total_mass() const {
    double sum = 0.0;
    for (const Member& rod : rods) sum += rod.mass;
    return sum;
  }

  [[nodiscard]] double mean_velocity() const {
    double sum = 0.0;
    for (const Member& rod : rods) sum += rod.mass * rod.velocity;
    return sum / total_mass();
  }

  /// Share of the energy of a vibration that is left after a time.
  [[nodiscard]] double kept(double elapsed) const {
    if (!decay_time) return 1.0;
    return *decay_time > 0.0 ? std::exp(-elapsed / *decay_time) : 0.0;
  }

  /// Energy that the vibration of a rod has lost since it was seen last.
  [[nodiscard]] double decayed(std::size_t rod) const {
    return decay_time ? vibrations->energy(rod) * (1.0 - kept(time - rods[rod].seen)) : 0.0;
  }

  void age(std::size_t rod) {
    const double elapsed = time - rods[rod].seen;
    dissipated += decayed(rod);
    vibrations->age(rod, elapsed, kept(elapsed));
    rods[rod].seen = time;
  }

  /// Brings the gap of a pair up to date.
  void meet_later(std::size_t pair) {
    pairs[pair].gap = std::max(0.0, pairs[pair].gap - closing(pair) * (time - pairs[pair].seen));
    pairs[pair].seen = time;
  }

  void foresee(std::size_t pair) {
    const double speed = closing(pair);
    pairs[pair].next = speed > 0.0 ? time + pairs[pair].gap / speed : never;
  }

  [[nodiscard]] std::size_t first() const {
    const auto sooner = [](const Pair& a, const Pair& b) { return a.next < b.next; };
    return static_cast<std::size_t>(std::min_element(pairs.begin(), pairs.end(), sooner) - pairs.begin());
  }

  /// Throws where collisions accumulate.
  void watch(double due) {
    constexpr double rounding = 1e-13;
    constexpr long most = 2000;
    if (due - crowded_since > rounding * due) {
      crowded_since = due;
      crowded = 0;
    } else if (++crowded > most) {
      throw NotConverged("rod_chain: " + std::to_string(most) + " collisions within 1e-13 of the time " + shown(due) +
                         " (inelastic collapse: fewer rods, more equal ones or a longer decay_time avoid it)");
    }
  }

  /// Moves to the frame of the centre of mass: of slow rods, a velocity that rounding has left to all hides the digits.
  void settle() {
    const double mean = mean_velocity();
    for (Member& rod : rods) rod.velocity -= mean;
    drift += mean;
  }

  RodCollision collide();
};

RodCollision RodChain::State::collide() {
  const std::size_t left = first(), right = right_of(left);
  const double due = pairs[left].next;
  if (due == never) throw InvalidInput::conflict("rod_chain", "no collision is due", "the rods only part, or rest");
  watch(due);
  time = std::max(time, due);
  RodCollision result;
  result.time = time;
  result.pair = left;
  result.speed = closing(left);
  for (const std::size_t rod : {left, right}) {
    age(rod);
    result.vibration_before += vibrations->energy(rod);
  }
  const RodMeeting met = vibrations->meet(left, right, result.speed);
  result.restitution = met.restitution;
  result.unresolved = met.unresolved;
  for (const std::size_t rod : {left, right}) result.vibration_after += vibrations->energy(rod);

  const std::size_t before = (left == 0 ? rods.size() : left) - 1;
  for (const std::size_t pair : {before, right}) meet_later(pair);
  pairs[left].gap = 0.0;
  pairs[left].seen = time;
  const double impulse_per_mass = (1.0 + met.restitution) * result.speed / (rods[left].mass + rods[right].mass);
  const double to_left = impulse_per_mass * rods[right].mass, to_right = impulse_per_mass * rods[left].mass;
  rods[left].velocity -= to_left;
  rods[right].velocity += to_right;
  for (const std::size_t pair : {before, left, right}) foresee(pair);
  unresolved += met.unresolved;
  constexpr long often = 10;  // collisions of each rod
  if (++collisions % (often * static_cast<long>(rods.size())) == 0) settle();
  return result;
}

RodChain::RodChain(std::vector<Rod> rods, double circumference, const std::vector<double>& velocities,
                   const RodChainOptions& options)
    : state_(std::make_unique<State>()) {
  validate(rods, circumference, velocities, options);
  double length = 0.0;
  for (std::size_t k = 0; k < rods.size(); ++k) {
    state_->rods.push_back({RodMeasures(rods[k]).mass, velocities[k]});
    length += rods[k].length;
  }
  state_->pairs.resize(rods.size(), {(circumference - length) / static_cast<double>(rods.size())});
  state_->decay_time = options.decay_time;
  if (options.method == RodMethod::modes) {
    state_->vibrations = std::make_unique<RodModes>(rods, options);
  } else {
    state_->vibrations = std::make_unique<RodWaves>(rods, options);
  }
  state_->settle();
  for (std::size_t pair = 0; pair < rods.size(); ++pair) state_->foresee(pair);
}

RodChain::RodChain(RodChain&&) noexcept = default;
RodChain& RodChain::operator=(RodChain&&) noexcept = default;
RodChain::~RodChain() = default;

double RodChain::next() const { return state_->pairs[state_->first()].next; }

RodCollision RodChain::collide() { return state_->collide(); }

void RodChain::fly(double time) {
  if (!(time >= state_->time && time <= next()) || time == never) {
    throw InvalidInput::out_of_range(
        "time", shown(time), "from " + shown(state_->time) + " to " + shown(next()) + ", when the next rods meet");
  }
  state_->time = time;
}

RodChainSample RodChain::sample() const {
  const State& now = *state_;
  const double mean = now.mean_velocity();
  RodChainSample sample;
  sample.time = now.time;
  sample.collisions = now.collisions;
  sample.dissipated = now.dissipated;
  sample.unresolved = now.unresolved;
  sample.momentum = now.total_mass() * (now.drift + mean);
  for (std::size_t k = 0; k < now.rods.size(); ++k) {
    const double velocity = now.rods[k].velocity - mean;
    sample.translation += 0.5 * now.rods[k].mass * velocity * velocity;
    sample.vibration += now.vibrations->energy(k) - now.decayed(k);
    sample.dissipated += now.decayed(k);
  }
  return sample;
}

std::vector<double> RodChain::velocities() const {
  std::vector<double> result;
  for (const State::Member& rod : state_->rods) result.push_back(state_->drift + rod.velocity);
  return result;
}

void RodChain::reverse() {
  for (std::size_t k = 0; k < state_->rods.size(); ++k) {
    state_->age(k);
    state_->vibrations->reverse(k);
    state_->meet_later(k);
  }
  state_->drift = -state_->drift;
  for (State::Member& rod : state_->rods) rod.velocity = -rod.velocity;
  for (std::size_t k = 0; k < state_->rods.size(); ++k) state_->foresee(k);
}

}  // namespace stoss
