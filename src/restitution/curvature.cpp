#include "restitution/curvature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "check.hpp"
#include "impact/recommended.hpp"

namespace stoss {
namespace {

/// How much larger than the usual part those are from which ε is extrapolated: twice, and twice again, or the whole.
std::vector<double> stretches(const RefinableContact& contact) {
  std::vector<double> result{1.0};
  while (result.size() < 3 && result.back() * contact.part() < 1.0) {
    result.push_back(std::min(2.0 * result.back(), 1.0 / contact.part()));
  }
  return result;
}

/// One resolution for all: with nodes of their own each would err in another way, which the extrapolation would
/// enlarge.
Resolution common_resolution(const std::vector<const Contact*>& contacts, double speed) {
  Resolution common = refined_resolution(*contacts.front(), speed, 0.0);
  for (const Contact* contact : contacts) {
    const Resolution own = refined_resolution(*contact, speed, 0.0);
    common.step = std::min(*common.step, *own.step);
    if (common.nodes) common.nodes = std::max(*common.nodes, *own.nodes);
  }
  return common;
}

/// ε with a part of each size.
std::vector<double> restitutions(const RefinableContact& contact, double cutoff, double speed, const Poll& poll) {
  std::vector<const Contact*> contacts;
  for (const double stretch : stretches(contact)) contacts.push_back(&contact.at(cutoff, stretch, poll));
  const ImpactOptions options{.resolution = common_resolution(contacts, speed), .poll = poll};
  std::vector<double> values;
  values.reserve(contacts.size());
  for (const Contact* each : contacts) values.push_back(impact(*each, speed, options).restitution);
  return values;
}

/// Value at curvature 1 of the polynomial through all parts but the first `without`.
double extrapolated(const RefinableContact& contact, const std::vector<double>& values, std::size_t without) {
  std::vector<double> curvature;
  for (const double stretch : stretches(contact)) curvature.push_back(1.0 / (contact.part() * stretch));
  double sum = 0.0;
  for (std::size_t i = without; i < values.size(); ++i) {
    double weight = 1.0;
    for (std::size_t j = without; j < values.size(); ++j) {
      if (j != i) weight *= (1.0 - curvature[j]) / (curvature[i] - curvature[j]);
    }
    sum += weight * values[i];
  }
  return sum;
}

}  // namespace

CurvatureCorrection curvature_correction(const RefinableContact& contact, double speed, const Poll& poll) {
  if (contact.part() == 1.0) return {};
  constexpr int usual_level = 2;  // the largest part has the fewest cutoffs
  const double coarse = std::min(contact.cutoff(usual_level), 0.25 * contact.cutoff(contact.highest_level()));
  const auto values = restitutions(contact, coarse, speed, poll);
  const auto others = restitutions(contact, coarse / std::numbers::sqrt2, speed, poll);
  const double whole = extrapolated(contact, values, 0);
  const double shift = whole - values.front();
  const double other_shift = extrapolated(contact, others, 0) - others.front();
  return {shift, std::abs(whole - extrapolated(contact, values, 1)) + std::abs(shift - other_shift)};
}

double neglected(const CurvatureCorrection& correction, const Impact& impact) {
  return 2.0 * std::abs(impact.restitution) * correction.error;
}

std::string out_of_reach(const CurvatureCorrection& correction, const Restitution& result) {
  const double reachable = neglected(correction, result.finest) / std::abs(result.lost_fraction.value);
  if (reachable < result.tolerance) return {};
  return "the near side of the larger body stands for it less accurately than the tolerance asks (use a larger one, "
         "from " +
         rounded(1.1 * reachable, 2) + ")";
}

void correct(const CurvatureCorrection& correction, const Contact& contact, Impact& impact) {
  if (correction.shift == 0.0) return;
  const double before = impact.lost_fraction;
  impact.restitution += correction.shift;
  impact.lost_fraction = 1.0 - impact.restitution * impact.restitution;
  const double more = impact.lost_fraction - before;
  EnergyLedger& ledger = impact.energy;
  ledger.translation -= more;
  ledger.vibration += more;
  (contact.first->part.size < 1.0 ? ledger.lost_to_first : ledger.lost_to_second) += more;
}

}  // namespace stoss
