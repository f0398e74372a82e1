#include "stoss/prediction/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "check.hpp"
#include "prediction/constants.hpp"
#include "prediction/touching.hpp"
#include "prediction/warnings.hpp"
#include "restitution/ordered_jobs.hpp"
#include "stoss/encounter/roughness.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss {
namespace {

using prediction::Computed;
using prediction::PredictedImpact;
using prediction::Touching;
using prediction::Variant;
using prediction::Waves;
using prediction::WavyImpact;
using quasistatic::YieldLaw;

constexpr double gravity = 9.80665;  // m/s²

/// With the moduli at a frequency, rad/s.
Encounter without_loss(Encounter encounter, double frequency) {
  for (Participant* each : {&encounter.first, &encounter.against}) {
    if (!each->material) continue;
    const std::vector<Losses> losses = losses_of_layers(*each);
    for (const char* loss : {"loss_time", "quality"}) each->values.erase(loss);
    each->relaxation.reset(), each->material_name.clear();
    const auto strip = [&losses, frequency](Material& its, std::size_t layer) {
      its.loss_time.reset(), its.quality.reset(), its.relaxation.reset();
      its.young *= prediction::stiffer(losses[layer], frequency);
    };
    strip(*each->material, 0);
    for (std::size_t i = 0; i < each->below.size(); ++i) {
      strip(*each->below[i].material, i + 1);
      each->below[i].material_name.clear();
    }
  }
  return encounter;
}

Encounter with_smooth_faces(Encounter encounter) {
  for (Participant* each : {&encounter.first, &encounter.against}) {
    std::erase_if(each->values, [](const auto& of) { return is_of_face(of.first); });
  }
  return encounter;
}

/// One impact of elastic or lossy bodies.
Restitution computed_impact(const Encounter& encounter, double speed, double tolerance, const Poll& poll) {
  constexpr double small = 1e-5;  // error of 1 − ε², which models and constants exceed
  return best_restitution(refinable(encounter), speed_in_c(encounter, speed),
                          {.tolerance = tolerance, .absolute = small, .poll = poll});
}

/// Its channels. @param rings,radiates what they take of the waves, in any unit @param time unit of time, s
Computed channels(const Restitution& its, double rings, double radiates, double time) {
  const double waves = std::max(its.lost_fraction.value - its.dissipated, 0.0);
  const double sum = rings + radiates, radiated = sum > 0.0 ? waves * radiates / sum : 0.0;
  return {its.restitution.value, waves - radiated, radiated, its.contact_time.value * time};
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
        impact_(computed_impact(given, speed, options.tolerance, poll)),
        touching_(prediction::touching(given, options.work_of_adhesion, frequency())),
        computed_(computed_channels()) {}

  [[nodiscard]] Prediction predicted() const {
    Prediction made;
    made.speed = speed_;
    made.without_models = impact_.restitution;
    made.drop_height = speed_ * speed_ / (2.0 * gravity);
    if (std::isnan(computed_.restitution)) {
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      made.restitution = {none, none};
      made.by_models = made.by_constants = made.models_low = made.models_high = none;
      made.rebound_height = made.contact_time = none;
      made.shares.fill(none);
    } else {
      add_models(made);
      if (options_.influences) add_influences(made);
    }
    made.warnings = prediction::warnings(encounter_, limits_, impact_, made);
    if (asperities_of(encounter_) > 0.0 && !std::isnan(computed_.restitution)) {
      const Restitution its = computed_impact(with_smooth_faces(encounter_), speed_, options_.tolerance, poll_);
      const double waves = std::max(its.lost_fraction.value - its.dissipated, 0.0);
      made.warnings.push_back(prediction::saved_by_asperities(computed_.waves(), waves));
    }
    return made;
  }

 private:
  [[nodiscard]] Computed computed_channels() const {
    const Kind& met = kind(encounter_.against.kind);
    const bool failed = impact_.runs.empty();  // all is NaN
    if (met.wall || met.bounded || failed) return channels(impact_, 1.0, 0.0, unit_);
    if (impact_.dissipated == 0.0) return channels(impact_, impact_.lost_to_first, impact_.lost_to_second, unit_);
    // As the bodies without loss share them, since heat counts with each. A long contact needs so many modes of the
    // block that one coarse impact must do: hardly anything rings then.
    constexpr double roughly = 0.1, longest = 100.0;
    const Encounter lossless = without_loss(encounter_, *frequency());
    if (duration() <= longest) {
      const Restitution parts = computed_impact(lossless, speed_, roughly, poll_);
      return channels(impact_, parts.lost_to_first, parts.lost_to_second, unit_);
    }
    const EnergyLedger its = impact_at(lossless, impact_.runs.front().cutoff).energy;
    return channels(impact_, std::max(its.lost_to_first - its.unresolved, 0.0), its.lost_to_second, unit_);
  }

  /// At which the contact asks for moduli: half a period of it is the time of contact.
  [[nodiscard]] std::optional<double> frequency() const {
    const double time = duration() * unit_;
    return std::isfinite(time) && time > 0.0 ? std::optional(std::numbers::pi / time) : std::nullopt;
  }

  /// Of the contact, R/c of the ball.
  [[nodiscard]] double duration() const { return impact_.contact_time.value; }

  /// One impact with as many nodes as the coarsest of these.
  [[nodiscard]] Impact impact_at(const Encounter& encounter, double cutoff) const {
    const FixedResolution& coarse = impact_.runs.front().resolution;
    const double speed = speed_in_c(encounter, speed_);
    ImpactOptions how{.poll = poll_};
    how.resolution = {.nodes = coarse.nodes, .tail = coarse.tail};
    return impact(contact_of(encounter, cutoff, speed), speed, how);
  }

  [[nodiscard]] Waves waves() const { return touching_.sheet ? Waves::of_force : Waves::of_rate; }

  void add_models(Prediction& made) const {
    const WavyImpact motion(computed_, waves());
    const PredictedImpact whole = motion.with(touching_, speed_);
    const Estimate& alone = made.without_models;
    made.restitution = {whole.restitution,
                        alone.value > 0.0 ? alone.error * whole.restitution / alone.value : alone.error};
    made.shares = whole.shares;
    const auto largest = std::max_element(made.shares.begin(), made.shares.end());
    made.dominant = static_cast<Channel>(largest - made.shares.begin());
    made.rebound_height = whole.restitution * whole.restitution * made.drop_height;
    made.contact_time = whole.time;
    spread(motion, made);
  }

  /// How far models are from their ε: other published laws of yield and what the own one leaves open, how far adhesion
  /// is that of Johnson, Kendall and Roberts, and how a plate answers.
  void spread(const WavyImpact& motion, Prediction& made) const {
    const double its = made.restitution.value;
    made.models_low = made.models_high = its;
    const auto take = [&made](double other) {
      made.models_low = std::min(made.models_low, other);
      made.models_high = std::max(made.models_high, other);
    };
    const auto& onset = touching_.yield_speed;
    if (onset && speed_ > *onset) {
      take(motion.with(touching_, speed_, YieldLaw::thornton_ning).restitution);
      const double ratio = speed_ / *onset, fully = quasistatic::fully_plastic_restitution(ratio);
      const double own = plastic_restitution(YieldLaw::finite_elements, ratio);
      take(std::min(its * fully / own, computed_.restitution));
      // Above some 1900 V_y both are below: the own law is then the highest, and known no better than to its fit and to
      // Poisson's ratio, 1 % and 3 or 4 % of ε² where yield takes all (elastic_plastic.hpp).
      constexpr double higher = 0.04, lower = 0.05;
      const double share = made.share(Channel::yield);
      take(std::min(its * std::sqrt(1.0 + higher * share), computed_.restitution));
      take(its * std::sqrt(1.0 - lower * share));
    }
    if (touching_.work_of_adhesion > 0.0) {
      constexpr double none = 0.1, full = 5.0;  // Tabor's numbers
      const double share = std::clamp(std::log(touching_.tabor_number() / none) / std::log(full / none), 0.0, 1.0);
      Touching smooth = touching_;
      smooth.work_of_adhesion = 0.0;
      take(its + (1.0 - share) * (motion.with(smooth, speed_).restitution - its));
    }
    if (touching_.sheet) take(WavyImpact(computed_, Waves::of_rate).with(touching_, speed_).restitution);
    made.by_models = std::max(its - made.models_low, made.models_high - its);
  }

  /// An impact that shows what bodies nearly the same change: the coarsest, or of a long contact with a block, whose
  /// waves are long, one with a lower cutoff, as the number of its modes grows with cutoff and duration.
  [[nodiscard]] Run coarse() const {
    constexpr double enough = 150.0;  // radians within the contact
    Run made = impact_.runs.front();
    const Kind& met = kind(encounter_.against.kind);
    if (met.wall || met.bounded || touching_.sheet || made.cutoff * duration() <= enough) return made;
    made.cutoff = enough / duration();
    const Impact its = impact_at(encounter_, made.cutoff);
    made.lost_fraction = its.lost_fraction, made.dissipated = its.energy.dissipated;
    return made;
  }

  /// Of bodies nearly the same: one impact like the coarse one, whose errors are nearly the same too.
  [[nodiscard]] Computed computed_of(const Encounter& encounter, const Run& coarse) const {
    const Impact its = impact_at(encounter, coarse.cutoff);
    const double lost = impact_.lost_fraction.value + its.lost_fraction - coarse.lost_fraction;
    const double material = impact_.dissipated + its.energy.dissipated - coarse.dissipated;
    return {std::sqrt(std::max(1.0 - lost, 0.0)), std::max(lost - material, 0.0)};
  }

  void add_influences(Prediction& made) const {
    double square = 0.0;
    const Run as_here = coarse();
    for (const Variant& variant : prediction::variants(encounter_, options_)) {
      const Computed computed = variant.computed ? computed_of(variant.encounter, as_here) : computed_;
      const Touching its = prediction::touching(variant.encounter, variant.work_of_adhesion, frequency());
      const WavyImpact motion(computed, waves());
      const double change = motion.with(its, speed_).restitution - made.restitution.value;
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
  Restitution impact_;
  Touching touching_;
  Computed computed_;
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
