// A body that comes back: with ω the frequency of a mode and T the nominal time of a flight, its phase is ωT further
// and its energy e^(−T/τ) of what it was.
#include "stoss/vibration/bounce.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "check.hpp"
#include "impact/free_flight.hpp"

namespace stoss {
namespace {

constexpr double slowest = 1e-8, fastest = 1.0;  // of an impact, c

/// Of the whole body, which in contact with a part of a half-space moves less than in Impact::final_state.
double center_after(const Contact& contact, const Impact& impact) {
  const double part = contact.mass / contact.whole_mass, center = impact.final_state.center;
  if (part == 1.0) return center;
  const double free = impact.start->center + impact.speed * static_cast<double>(impact.steps) * impact.resolution.step;
  return free - part * (free - center);
}

/// Number of modes of the body that comes back; those after them are waves in a half-space.
std::size_t own_modes(const Contact& contact) {
  std::size_t count = 0;
  for (std::size_t g = 0; g < contact.first_groups; ++g) count += contact.groups[g].omega.size();
  return count;
}

/// Turns the phase of every mode by ω times a time, at its energy.
void turn(const Contact& contact, State& state, double time) {
  for (std::size_t g = 0, k = 0; g < contact.groups.size(); ++g) {
    for (const double omega : contact.groups[g].omega) {
      const double inertia = modal_mass(contact, g) * omega, cosine = std::cos(omega * time);
      const double sine = std::sin(omega * time), coordinate = state.coordinate[k], momentum = state.momentum[k];
      state.coordinate[k] = coordinate * cosine + momentum / inertia * sine;
      state.momentum[k++] = momentum * cosine - coordinate * inertia * sine;
    }
  }
}

/// How the next impact begins.
struct Beginning {
  std::optional<State> state;  // nothing of an unexcited body
  bool short_flight = false;
};

Beginning after_flight(const Contact& contact, const Impact& impact, double speed, double flight,
                       const std::optional<double>& decay_time) {
  State state = impact.final_state;
  state.velocity = speed;
  const double kept = decay_time ? std::exp(-0.5 * flight / *decay_time) : 1.0;  // 0 for a decay time of 0
  const std::size_t own = own_modes(contact);
  bool moves = false;
  for (std::size_t k = 0; k < state.coordinate.size(); ++k) {
    const double factor = k < own ? kept : 0.0;
    state.coordinate[k] *= factor;
    state.momentum[k] *= factor;
    moves = moves || state.coordinate[k] != 0.0 || state.momentum[k] != 0.0;
  }
  if (!moves && state.pressed == 0.0) return {};
  const double to_touch = flight + (contact.extent + center_after(contact, impact)) / speed;
  const double distance = loses(contact) ? clearance(contact, state)
                                         : speed * time_before_touch(contact, free_motion(contact, state, to_touch));
  const double time = to_touch - distance / speed;
  if (time < 0.0 && loses(contact)) {
    turn(contact, state, time);  // back in time it would grow
  } else {
    state = free_motion(contact, state, time);
  }
  state.center = -contact.extent - distance;
  return {std::move(state), time < 0.0};
}

class Sequence {
 public:
  Sequence(const Contact& contact, double speed, const BounceOptions& options)
      : contact_(contact), options_(options), speed_(speed) {
    const bool vibrates = !options.vibration.empty();
    // Where the whole body is after an impact on a half-space follows from where it was before.
    const bool part = contact.mass != contact.whole_mass && options.decay_time.value_or(1.0) > 0.0;
    if (vibrates || part) beginning_.state = approach(contact, speed, options.vibration);
    unit_ = translation() + vibration();
  }

  /// The next impact, and the flight after it.
  Bounce advance(Impact& impact) {
    if (!(speed_ >= slowest && speed_ <= fastest)) {
      throw NotConverged("bounce: the speed after impact " + std::to_string(number_) + " is " + rounded(speed_) +
                         " c, allowed 1e-8 to 1 (the impacts before are done)");
    }
    Bounce bounce{.number = ++number_, .speed = speed_, .short_flight = beginning_.short_flight};
    const double vibration_before = vibration() / unit_;
    const bool damped = options_.decay_time || loses(contact_);
    if (damped && number_ > 1) energy_.dissipated += energy_.vibration - vibration_before;
    bounce.before = {translation() / unit_, vibration_before, energy_.dissipated, energy_.unresolved};
    impact =
        stoss::impact(contact_, speed_,
                      {.resolution = options_.resolution, .start = std::move(beginning_.state), .poll = options_.poll});
    take(impact, bounce.before.translation + bounce.before.vibration);
    bounce.restitution = impact.restitution;
    bounce.after = energy_;
    bounce.energy_error = 1.0 - energy_.translation - energy_.vibration - energy_.dissipated - energy_.unresolved;
    bounce.contact_time = impact.contact_time;
    bounce.dent = impact.dent;
    bounce.strain = impact.strain;
    bounce.beyond_small_strain = impact.beyond_small_strain;
    speed_ *= impact.restitution;
    bounce.flight_time = options_.gravity ? 2.0 * speed_ / *options_.gravity : *options_.flight_time;
    if (number_ < options_.count && speed_ > 0.0) {
      beginning_ = after_flight(contact_, impact, speed_, bounce.flight_time, options_.decay_time);
    }
    return bounce;
  }

 private:
  [[nodiscard]] double translation() const { return 0.5 * contact_.whole_mass * speed_ * speed_; }

  [[nodiscard]] double vibration() const {
    double sum = 0.0;
    if (!beginning_.state) return sum;
    for (const double energy : mode_energies(contact_, *beginning_.state)) sum += energy;
    return sum;
  }

  /// Adds what an impact has done with a share of the energy.
  void take(const Impact& impact, double share) {
    const EnergyLedger& ledger = impact.energy;
    double own = 0.0;
    for (const ModeEnergy& mode : ledger.modes) own += mode.body == 0 ? mode.after : 0.0;
    energy_.translation = ledger.translation * share;
    energy_.vibration = own * share;
    // What a lossy body still holds where it relaxes becomes heat in flight.
    const double relaxing = loses(contact_) ? ledger.stored : 0.0;
    energy_.dissipated += (ledger.dissipated + ledger.yielded + relaxing) * share;
    const double waves = contact_.unbounded ? ledger.vibration - own : 0.0;
    energy_.unresolved += (ledger.unresolved + waves) * share;
  }

  const Contact& contact_;
  const BounceOptions& options_;
  double speed_;
  Beginning beginning_;
  double unit_;  // of energies
  long number_ = 0;
  SequenceEnergy energy_;  // after the last impact
};

}  // namespace

BounceNotConverged::BounceNotConverged(const NotConverged& cause, std::vector<Bounce> impacts)
    : NotConverged(cause), done(std::move(impacts)) {}

void validate(const Contact& contact, double speed, const BounceOptions& options) {
  if (contact.second != nullptr && !contact.unbounded) {
    throw InvalidInput::out_of_range("against", "a free body", "a wall or a half-space",
                                     "two free bodies that have met do not come back to each other");
  }
  require_speed(speed);
  require("count", static_cast<double>(options.count), ranges::count, "impacts");
  if (options.flight_time.has_value() == options.gravity.has_value()) {
    throw InvalidInput::out_of_range("flight_time", (options.gravity ? "it and gravity" : "neither it nor gravity"),
                                     "exactly one", "gravity g makes the flight 2v/g");
  }
  if (options.flight_time) {
    require("flight_time", *options.flight_time, ranges::flight_time, "R/c");
  }
  if (options.gravity) require("gravity", *options.gravity, ranges::gravity, "c^2/R");
  if (options.decay_time) {
    require("decay_time", *options.decay_time, ranges::decay_time, "R/c, of the vibration in flight");
  }
  if (!options.vibration.empty()) (void)approach(contact, speed, options.vibration);
}

double slowest_bounce(double speed) { return std::max(slowest, 0.1 * speed); }

void bounce(const Contact& contact, double speed, const BounceOptions& options, const BounceObserver& observer) {
  validate(contact, speed, options);
  Sequence sequence(contact, speed, options);
  Impact impact;
  for (long i = 0; i < options.count; ++i) {
    const Bounce bounce = sequence.advance(impact);
    observer(bounce, impact);
  }
}

std::vector<Bounce> bounce(const Contact& contact, double speed, const BounceOptions& options) {
  std::vector<Bounce> impacts;
  try {
    bounce(contact, speed, options, [&](const Bounce& bounce, const Impact&) { impacts.push_back(bounce); });
  } catch (const NotConverged& error) {
    throw BounceNotConverged(error, std::move(impacts));
  }
  return impacts;
}

}  // namespace stoss
