#include "restitution/doubts.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "contact/unit_ratios.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Curvature of what the first or the second body meets, in its units of length.
double curvature_met(const Contact& contact, bool first) {
  if (contact.second == nullptr) return 0.0;
  const double length = units_of(contact, 1).length;
  return first ? contact.second->curvature / length : contact.first->curvature * length;
}

struct Affected {
  Estimate Restitution::*estimate;
  double Impact::*value;
  int length;  ///< power of the unit of length in its unit
};

constexpr std::array affected{Affected{&Restitution::lost_fraction, &Impact::lost_fraction, 0},
                              Affected{&Restitution::contact_time, &Impact::contact_time, 1},
                              Affected{&Restitution::impulse_time, &Impact::impulse_time, 1},
                              Affected{&Restitution::max_force, &Impact::max_force, -1},
                              Affected{&Restitution::max_compression, &Impact::max_compression, 1}};

}  // namespace

std::vector<Contact> alternatives(const Contact& contact, Affects motion) {
  std::vector<Contact> all;
  for (const bool first : {true, false}) {
    const std::shared_ptr<const Body>& body = first ? contact.first : contact.second;
    if (body == nullptr) continue;
    const auto& others = motion == Affects::both ? body->known.alternatives : body->known.alternatives_along;
    if (!others) continue;
    for (Body& each : others(curvature_met(contact, first))) {
      auto other = std::make_shared<const Body>(std::move(each));
      if (contact.second == nullptr) {
        all.push_back(stoss::contact(std::move(other), contact.wall));
      } else {
        all.push_back(first ? stoss::contact(std::move(other), contact.second)
                            : stoss::contact(contact.first, std::move(other)));
      }
    }
  }
  return all;
}

ImpactOptions options_of(const Contact& other, const Contact& contact, const Impact& impact, const Poll& poll) {
  const double length = other.first->scale.length / contact.first->scale.length;
  ImpactOptions own{.resolution = Resolution(impact.resolution), .poll = poll};
  own.start = impact.start;
  if (own.resolution.step) *own.resolution.step /= length;
  if (own.resolution.half_width) *own.resolution.half_width /= length;
  if (!own.start) return own;
  own.start->center = (contact.extent + own.start->center) / length - other.extent;
  for (double& each : own.start->coordinate) each /= length;
  for (double& each : own.start->momentum) each *= other.mass / contact.mass;
  return own;
}

void add_doubts(const RefinableContact& contact, double speed, double stretch, const RestitutionOptions& options,
                Restitution& result) {
  const Impact& finest = result.finest;
  const Contact& resolved = contact.at(result.runs.back().cutoff, stretch, options.poll);
  const std::vector<Contact> others = alternatives(resolved, Affects::both);
  if (others.empty()) return;
  // Of few modes the energies above the cutoff, by which the ladder judges, may be smaller than what is gained or lost.
  result.lost_fraction.error += std::abs(finest.energy_error);
  for (const Contact& other : others) {
    const double length = other.first->scale.length / resolved.first->scale.length;
    try {
      const Impact changed = impact(other, speed, options_of(other, resolved, finest, options.poll));
      for (const auto& [estimate, value, power] : affected) {
        (result.*estimate).error += std::abs(changed.*value * std::pow(length, power) - finest.*value);
      }
    } catch (const NotConverged&) {  // the body might be one that cannot be computed: nothing is certain
      for (const auto& [estimate, value, power] : affected) {
        (result.*estimate).error = std::numeric_limits<double>::infinity();
      }
    }
  }
  const double error = result.lost_fraction.error, squared = std::max(0.0, 1.0 - result.lost_fraction.value);
  result.restitution.error =
      std::isinf(error) ? error : error / (std::sqrt(squared + error) + std::abs(result.restitution.value));
}

}  // namespace stoss
