#include "stoss/prediction/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "check.hpp"
#include "encounter/participant.hpp"
#include "prediction/constants.hpp"
#include "prediction/idealized.hpp"
#include "prediction/touching.hpp"
#include "prediction/warnings.hpp"
#include "prediction/waves.hpp"
#include "restitution/ordered_jobs.hpp"
#include "restitution/yield_errors.hpp"
#include "stoss/encounter/roughness.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss {
namespace {

using prediction::as_it_yields;
using prediction::Touching;
using prediction::Variant;
using prediction::waves_of;
using prediction::without_yield;

constexpr double gravity = 9.80665;  // m/s²

/// One impact, with what of it is computed, and yield as its law has it.
Restitution computed_impact(const Encounter& encounter, double speed, double tolerance, const Poll& poll) {
  constexpr double small = 1e-5;  // error of 1 − ε², which models and constants exceed
  return best_restitution(refinable(encounter), speed_in_c(encounter, speed),
                          {.tolerance = tolerance, .absolute = small, .poll = poll});
}

/// One speed, with all that it needs.
class PredictionAtSpeed {
 public:
  PredictionAtSpeed(const Encounter& given, const Thresholds& limits, double speed, const PredictionOptions& options,
                    const Poll& poll)
      : encounter_(given),
        limits_(limits),
        speed_(speed),
        options_(options),
        poll_(poll),
        unit_(si_scales(given)->time),
        elastic_(computed_impact(without_yield(given), speed, options.tolerance, poll)),
        touching_(prediction::touching(given, options.work_of_adhesion, frequency())),
        yields_(yields(given)),
        real_(yields_ ? computed_impact(as_it_yields(given), speed, options.tolerance, poll) : elastic_),
        doubt_(yields_ ? doubt() : 0.0) {}

  [[nodiscard]] Prediction predicted() const {
    Prediction made;
    made.speed = speed_;
    made.without_models = elastic_.restitution;
    made.drop_height = speed_ * speed_ / (2.0 * gravity);
    if (std::isnan(real_.restitution.value)) {
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      made.restitution = {none, none};
      made.by_models = made.by_constants = made.models_low = made.models_high = none;
      made.rebound_height = made.contact_time = none;
      made.shares.fill(none);
    } else {
      add_channels(made);
      spread(made);
      if (options_.influences) add_influences(made);
    }
    made.warnings = prediction::warnings(encounter_, limits_, real_, made);
    if (asperities_of(encounter_) > 0.0 && !std::isnan(elastic_.restitution.value)) {
      const Encounter smooth = without_yield(prediction::with_smooth_faces(encounter_));
      const Restitution its = computed_impact(smooth, speed_, options_.tolerance, poll_);
      made.warnings.push_back(prediction::saved_by_asperities(waves_of(elastic_), waves_of(its)));
    }
    return made;
  }

 private:
  /// What the law of yield leaves open of 1 − ε²: in the errors of the engine, here among the models.
  [[nodiscard]] double doubt() const {
    if (real_.runs.empty()) return 0.0;  // nothing is known
    const Encounter real = as_it_yields(encounter_);
    const Contact contact = contact_of(real, real_.runs.front().cutoff, speed_in_c(real, speed_));
    return std::min(doubt_of_yield(contact, real_.finest), real_.lost_fraction.error);
  }

  [[nodiscard]] bool yields(const Encounter& encounter) const {
    const auto coated = [](const Participant& of) { return of.values.contains("coat"); };
    if (coated(encounter.first) || coated(encounter.against)) return false;
    return touching_.yield_speed && speed_ > *touching_.yield_speed;
  }

  /// At which the contact asks for moduli, rad/s: half a period of it is the time of contact.
  [[nodiscard]] std::optional<double> frequency() const {
    const double time = elastic_.contact_time.value * unit_;
    return std::isfinite(time) && time > 0.0 ? std::optional(std::numbers::pi / time) : std::nullopt;
  }

  [[nodiscard]] bool at_block() const {
    const Kind& met = kind(encounter_.against.kind);
    return !met.wall && !met.bounded;
  }

  /// Share of the energy that adhesion takes as the bodies part, with the dent that they have.
  [[nodiscard]] double adhesion(const Touching& its) const {
    if (its.work_of_adhesion == 0.0) return 0.0;
    const double length = size_of_first(encounter_);
    const double compression = yields_ ? real_.max_compression.value * length : 0.0;
    return its.adhesion(compression) / (0.5 * its.mass * speed_ * speed_);
  }

  void add_channels(Prediction& made) const {
    const double left = std::max(0.0, 1.0 - real_.lost_fraction.value), adhesion = this->adhesion(touching_);
    const bool sticks = left <= adhesion;
    made.restitution = real_.restitution;
    if (adhesion > 0.0) made.restitution.value = sticks ? 0.0 : std::sqrt(left - adhesion);
    if (const double its = made.restitution.value; its > 0.0) {
      const double error = real_.lost_fraction.error - doubt_;
      made.restitution.error = error / (std::sqrt(its * its + error) + its);
    }
    const double waves = waves_of(real_), away = prediction::radiated(real_, at_block());
    made.shares = {waves - away, away, real_.dissipated, std::max(real_.yielded, 0.0), sticks ? left : adhesion};
    const auto largest = std::max_element(made.shares.begin(), made.shares.end());
    made.dominant = static_cast<Channel>(largest - made.shares.begin());
    made.rebound_height = made.restitution.value * made.restitution.value * made.drop_height;
    made.contact_time = sticks ? std::numeric_limits<double>::infinity() : real_.contact_time.value * unit_;
  }

  /// How far models are from their ε: what the law of yield leaves open, and how far adhesion is that of Johnson,
  /// Kendall and Roberts.
  void spread(Prediction& made) const {
    const double its = made.restitution.value;
    made.models_low = made.models_high = its;
    const auto take = [&made](double other) {
      made.models_low = std::min(made.models_low, other);
      made.models_high = std::max(made.models_high, other);
    };
    if (yields_) {  // Poisson's ratio: 3 or 4 % of ε² where yield takes all (elastic_plastic.hpp)
      constexpr double higher = 0.03, lower = 0.04;
      const double share = made.share(Channel::yield), square = its * its;
      take(std::min(std::sqrt(square * (1.0 + higher * share) + doubt_), elastic_.restitution.value));
      take(std::sqrt(std::max(0.0, square * (1.0 - lower * share) - doubt_)));
    }
    if (touching_.work_of_adhesion > 0.0) {
      const double left = std::max(0.0, 1.0 - real_.lost_fraction.value);
      const double least = prediction::least_work_of_jumps(touching_.tabor_number()) * adhesion(touching_);
      take(std::sqrt(std::max(0.0, left - least)));
    }
    made.by_models = std::max(its - made.models_low, made.models_high - its);
  }

  /// One impact with as many nodes as the coarsest of these.
  [[nodiscard]] Impact impact_at(const Encounter& encounter, double cutoff) const {
    const FixedResolution& coarse = real_.runs.front().resolution;
    const Encounter real = yields_ ? as_it_yields(encounter) : without_yield(encounter);
    const double speed = speed_in_c(real, speed_);
    ImpactOptions how{.poll = poll_};
    how.resolution = {.nodes = coarse.nodes, .tail = coarse.tail};
    return impact(contact_of(real, cutoff, speed), speed, how);
  }

  /// An impact that shows what bodies nearly the same change: the coarsest, or of a long contact with a block, whose
  /// waves are long, one with a lower cutoff, as the number of its modes grows with cutoff and duration.
  [[nodiscard]] Run coarse() const {
    constexpr double enough = 150.0;  // radians within the contact
    Run made = real_.runs.front();
    const double duration = real_.contact_time.value;
    if (!at_block() || encounter_.against.kind == "plate" || made.cutoff * duration <= enough) return made;
    made.cutoff = enough / duration;
    made.lost_fraction = impact_at(encounter_, made.cutoff).lost_fraction;
    return made;
  }

  /// ε of bodies nearly the same: of one impact like the coarse one, whose errors are nearly the same too.
  [[nodiscard]] double restitution_of(const Variant& variant, const Run& coarse) const {
    double lost = real_.lost_fraction.value;
    if (variant.computed) lost += impact_at(variant.encounter, coarse.cutoff).lost_fraction - coarse.lost_fraction;
    const Touching its = prediction::touching(variant.encounter, variant.work_of_adhesion, frequency());
    return std::sqrt(std::max(0.0, 1.0 - lost - adhesion(its)));
  }

  void add_influences(Prediction& made) const {
    double square = 0.0;
    const Run as_here = coarse();
    for (const Variant& variant : prediction::variants(encounter_, options_)) {
      const double change = restitution_of(variant, as_here) - made.restitution.value;
      made.influences.push_back({variant.constant, variant.uncertainty, change});
      square += change * change;
    }
    std::stable_sort(made.influences.begin(), made.influences.end(), [](const Influence& one, const Influence& other) {
      return std::abs(one.change) > std::abs(other.change);
    });
    made.by_constants = std::sqrt(square);
  }

  const Encounter& encounter_;
  const Thresholds& limits_;
  double speed_;
  const PredictionOptions& options_;
  const Poll& poll_;
  double unit_;  ///< R/c of the ball, s
  Restitution elastic_;
  Touching touching_;
  bool yields_;
  Restitution real_;
  double doubt_;
};

}  // namespace

double speed_of_drop(double height) {
  require("height", height, {0.0, 1e100, true, true, "0 or more"}, "of a fall, m");
  return std::sqrt(2.0 * gravity * height);
}

std::vector<Prediction> predict(const Encounter& encounter, const std::vector<double>& speeds,
                                const PredictionOptions& options) {
  const Thresholds limits = thresholds(encounter, options);
  (void)prediction::variants(encounter, options);  // refuses what is no constant
  require_tolerance(options.tolerance, 0.0);
  require("threads", static_cast<long>(options.threads), 0, 1024, "0 for as many as the machine has");
  for (const double speed : speeds) (void)speed_in_c(encounter, speed);
  std::vector<Prediction> made;
  made.reserve(speeds.size());
  const auto job = [&](std::size_t i, const Poll& heed) {
    return PredictionAtSpeed(encounter, limits, speeds[i], options, heed).predicted();
  };
  const auto deliver = [&made](std::size_t, Prediction&& each) { made.push_back(std::move(each)); };
  run_in_order<Prediction>(speeds.size(), options.threads, job, deliver, options.poll);
  return made;
}

}  // namespace stoss
