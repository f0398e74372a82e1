#include "restitution/curvature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "impact/resolution.hpp"

namespace stoss {
namespace {

constexpr std::array stretches{1.0, 2.0, 4.0};
constexpr std::size_t parts = stretches.size();

/// 1/size of a part.
double curvature(const RefinableContact& contact, std::size_t i) {
  return 1.0 / std::min(contact.part() * stretches[i], 1.0);
}

/// ε with each part.
std::array<double, parts> restitutions(const RefinableContact& contact, double cutoff, double speed, const Poll& poll) {
  std::array<double, parts> values{};
  for (std::size_t i = 0; i < parts; ++i) {
    const Contact& one = contact.at(cutoff, stretches[i], poll);
    ImpactOptions options = refined_resolution(one, speed, 0.0);
    options.poll = poll;
    values[i] = impact(one, speed, options).restitution;
  }
  return values;
}

/// Value at curvature 1 of the polynomial through the largest `count` parts.
double extrapolated(const RefinableContact& contact, const std::array<double, parts>& values, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = parts - count; i < parts; ++i) {
    double weight = 1.0;
    for (std::size_t j = parts - count; j < parts; ++j) {
      const double here = curvature(contact, i), there = curvature(contact, j);
      if (j != i) weight *= (1.0 - there) / (here - there);
    }
    sum += weight * values[i];
  }
  return sum;
}

}  // namespace

CurvatureCorrection curvature_correction(const RefinableContact& contact, double speed, const Poll& poll) {
  if (contact.part() == 1.0) return {};
  const double coarse = contact.cutoff(0), coarser = coarse / std::numbers::sqrt2;
  const auto values = restitutions(contact, coarse, speed, poll);
  const auto others = restitutions(contact, coarser, speed, poll);
  const double whole = extrapolated(contact, values, 3);
  const double shift = whole - values[0];
  const double other_shift = extrapolated(contact, others, 3) - others[0];
  return {shift, std::abs(whole - extrapolated(contact, values, 2)) + std::abs(shift - other_shift)};
}

double neglected(const CurvatureCorrection& correction, const Impact& impact) {
  return 2.0 * std::abs(impact.restitution) * correction.error;
}

std::string out_of_reach(const CurvatureCorrection& correction, const Restitution& result) {
  const double reachable = neglected(correction, result.finest) / std::abs(result.lost_fraction.value);
  if (reachable < result.tolerance) return {};
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", 1.1 * reachable);
  return std::string(
             "the near side of the larger body stands for it less accurately than the tolerance asks (use a "
             "larger one, from ") +
         text.data() + ")";
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
