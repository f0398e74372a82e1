#include "stoss/prediction/prediction.hpp"

#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "prediction/constants.hpp"
#include "prediction/motion.hpp"
#include "prediction/touching.hpp"
#include "prediction/warnings.hpp"
#include "restitution/ordered_jobs.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss {
namespace {

using prediction::Certified;
using prediction::Motion;
using prediction::Touching;
using prediction::Variant;
using prediction::Waves;
using prediction::Whole;
using quasistatic::YieldLaw;

constexpr double gravity = 9.80665;  // m/s²

Encounter without_loss(Encounter encounter) {
  for (Participant* each : {&encounter.first, &encounter.against}) {
    each->values.erase("loss_time");
    if (each->material) each->material->loss_time = 0.0;
    for (Participant& layer : each->below) layer.material->loss_time = 0.0;
    each->material_name.clear();
  }
  return encounter;
}

/// One impact of elastic or lossy bodies.
Restitution certified_impact(const Encounter& encounter, double speed, double tolerance, const Poll& poll) {
  constexpr double small = 1e-5;  // error of 1 − ε², which models and constants exceed
  return best_restitution(refinable(encounter), own_speed(encounter, speed),
                          {.tolerance = tolerance, .absolute = small, .poll = poll});
}

/// Its channels. What rings and what radiates are in the ratio of the bodies without loss, as heat counts with each.
Certified channels(const Restitution& its, const Restitution& parts, bool radiates) {
  const double waves = std::max(its.lost_fraction.value - its.dissipated, 0.0);
  const double sum = parts.lost_to_first + parts.lost_to_second;
  const double radiated = radiates && sum > 0.0 ? waves * parts.lost_to_second / sum : 0.0;
  return {its.restitution.value, waves - radiated, radiated, its.dissipated};
}

/// One speed, with all that it needs.
class Drop {
 public:
  Drop(const Encounter& given, const Thresholds& limits, double speed, const PredictionOptions& options,
       const Poll& poll)
      : given_(given),
        limits_(limits),
        speed_(speed),
        options_(options),
        poll_(poll),
        encounter_(prediction::at_duration(given, hertz_duration(given, speed, options))),
        touching_(prediction::touching(encounter_, options.work_of_adhesion)),
        impact_(certified_impact(encounter_, speed, options.tolerance, poll)),
        certified_(certified_channels()) {}

  [[nodiscard]] Prediction predicted() const {
    Prediction made;
    made.speed = speed_;
    made.elastic = impact_.restitution;
    made.drop_height = speed_ * speed_ / (2.0 * gravity);
    if (std::isnan(certified_.restitution)) {
      made.restitution = made.lowest = made.highest = made.constants = made.rebound_height = made.contact_time =
          certified_.restitution;
      made.shares.fill(certified_.restitution);
    } else {
      add_models(made);
      if (options_.influences) add_influences(made);
    }
    made.warnings = prediction::warnings(encounter_, limits_, impact_, made);
    return made;
  }

 private:
  static double hertz_duration(const Encounter& encounter, double speed, const PredictionOptions& options) {
    constexpr double duration = 3.2181;  // of Hertz' impact, (4/5) (5/4)^{2/5} B(2/5, 1/2)
    return duration * prediction::touching(encounter, options.work_of_adhesion).time(speed);
  }

  [[nodiscard]] Certified certified_channels() const {
    const Kind& met = kind(encounter_.against.kind);
    const bool radiates = !met.wall && !met.bounded;
    if (!radiates || impact_.dissipated == 0.0) return channels(impact_, impact_, radiates);
    constexpr double roughly = 0.1;
    return channels(impact_, certified_impact(without_loss(encounter_), speed_, roughly, poll_), radiates);
  }

  [[nodiscard]] Waves waves() const { return touching_.sheet ? Waves::of_force : Waves::of_rate; }

  void add_models(Prediction& made) const {
    const Motion motion(certified_, waves());
    const Whole whole = motion.with(touching_, speed_);
    made.restitution = whole.restitution;
    made.shares = whole.shares;
    const auto largest = std::max_element(made.shares.begin(), made.shares.end());
    made.dominant = static_cast<Channel>(largest - made.shares.begin());
    made.rebound_height = made.restitution * made.restitution * made.drop_height;
    made.contact_time = whole.time;
    spread(motion, made);
    made.lowest = std::max(made.lowest - made.certified_error(), 0.0);
    made.highest = std::min(made.highest + made.certified_error(), 1.0);
  }

  /// The band that models leave around their ε: other published laws of yield, how far adhesion is that of Johnson,
  /// Kendall and Roberts, and how a plate answers.
  void spread(const Motion& motion, Prediction& made) const {
    made.lowest = made.highest = made.restitution;
    const auto take = [&made](double other) {
      made.lowest = std::min(made.lowest, other);
      made.highest = std::max(made.highest, other);
    };
    const auto& onset = touching_.yield_speed;
    if (onset && speed_ > *onset) {
      take(motion.with(touching_, speed_, YieldLaw::thornton_ning).restitution);
      const double ratio = speed_ / *onset, fully = quasistatic::fully_plastic_restitution(ratio);
      const double own = plastic_restitution(YieldLaw::finite_elements, ratio);
      take(std::min(made.restitution * fully / own, certified_.restitution));
    }
    if (touching_.work_of_adhesion > 0.0) {
      constexpr double none = 0.1, full = 5.0;  // Tabor's numbers
      const double share = std::clamp(std::log(touching_.tabor_number() / none) / std::log(full / none), 0.0, 1.0);
      Touching smooth = touching_;
      smooth.work_of_adhesion = 0.0;
      take(made.restitution + (1.0 - share) * (motion.with(smooth, speed_).restitution - made.restitution));
    }
    if (touching_.sheet) take(Motion(certified_, Waves::of_rate).with(touching_, speed_).restitution);
  }

  /// Of bodies nearly the same: one impact like the coarsest of these, whose errors are nearly the same too.
  [[nodiscard]] Certified certified_of(const Encounter& encounter) const {
    const Run& coarse = impact_.runs.front();
    const double speed = own_speed(encounter, speed_);
    ImpactOptions how{.poll = poll_};
    how.resolution = {.nodes = coarse.resolution.nodes, .tail = coarse.resolution.tail};
    const Impact its = impact(contact_of(encounter, coarse.cutoff, speed), speed, how);
    const double lost = impact_.lost_fraction.value + its.lost_fraction - coarse.lost_fraction;
    const double material = impact_.dissipated + its.energy.dissipated - coarse.dissipated;
    return {std::sqrt(std::max(1.0 - lost, 0.0)), std::max(lost - material, 0.0), 0.0, material};
  }

  void add_influences(Prediction& made) const {
    double square = 0.0;
    for (const Variant& variant : prediction::variants(given_, encounter_, options_)) {
      const Certified certified = variant.elastic ? certified_of(variant.encounter) : certified_;
      const Touching its = prediction::touching(variant.encounter, variant.work_of_adhesion);
      const Motion motion(certified, waves(), variant.material_factor);
      const double change = motion.with(its, speed_).restitution - made.restitution;
      made.influences.push_back({variant.constant, variant.uncertainty, change});
      square += change * change;
    }
    std::stable_sort(made.influences.begin(), made.influences.end(), [](const Influence& one, const Influence& other) {
      return std::abs(one.change) > std::abs(other.change);
    });
    made.constants = std::sqrt(square);
  }

  const Encounter& given_;
  const Thresholds& limits_;
  double speed_;
  const PredictionOptions& options_;
  const Poll& poll_;
  Encounter encounter_;
  Touching touching_;
  Restitution impact_;
  Certified certified_;
};

}  // namespace

double speed_of_drop(double height) {
  require("height", height, {0.0, 1e100, true, true, "0 or more"}, "of a fall, m");
  return std::sqrt(2.0 * gravity * height);
}

std::vector<Prediction> predict(const Encounter& encounter, const std::vector<double>& speeds,
                                const PredictionOptions& options) {
  const Thresholds limits = thresholds(encounter, options);
  (void)prediction::variants(encounter, encounter, options);  // refuses what is no constant
  require_tolerance(options.tolerance, 0.0);
  require("threads", static_cast<long>(options.threads), 0, 1024, "0 for as many as the machine has");
  for (const double speed : speeds) (void)own_speed(encounter, speed);
  std::vector<Prediction> made;
  made.reserve(speeds.size());
  const auto job = [&](std::size_t i, const Poll& heed) {
    return Drop(encounter, limits, speeds[i], options, heed).predicted();
  };
  const auto deliver = [&made](std::size_t, Prediction&& each) { made.push_back(std::move(each)); };
  run_in_order<Prediction>(speeds.size(), options.threads, job, deliver, options.poll);
  return made;
}

}  // namespace stoss
