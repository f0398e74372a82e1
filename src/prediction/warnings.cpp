#include "prediction/warnings.hpp"

#include <array>
#include <cstdio>

#include "encounter/participant.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/encounter/roughness.hpp"

namespace stoss::prediction {
namespace {

std::string rounded(double number) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.2g", number);  // it fits
  return text.data();
}

bool has_loss(const Participant& of) {
  return of.rigid || kind(of.kind).wall || of.values.contains("loss_time") ||
         (of.material && of.material->loss_time.has_value()) || relaxes(of);
}

bool has_strength(const Participant& of) { return of.rigid || kind(of.kind).wall || strength_of(of).has_value(); }

}  // namespace

std::string saved_by_asperities(double rough, double smooth) {
  return "asperities: waves take " + rounded(rough) + " of the energy, " + rounded(smooth) + " between smooth faces";
}

std::vector<std::string> warnings(const Encounter& encounter, const Thresholds& limits, const Restitution& computed,
                                  const Prediction& made) {
  std::vector<std::string> all;
  if (limits.yield && made.speed > *limits.yield) {
    all.push_back("yields above " + rounded(*limits.yield) + " m/s: a model, without hardening");
  }
  if (limits.impression && made.speed > *limits.impression) {
    all.push_back("above " + rounded(*limits.impression) +
                  " m/s the impression is no longer small beside the radius: the model of yield ends, eps is lower");
  }
  if (made.speed < limits.sticking) {
    all.push_back("sticks below " + rounded(limits.sticking) + " m/s: a model, of smooth and clean surfaces");
  } else if (made.speed < limits.adhesion) {
    all.push_back("adhesion takes more than a hundredth of the energy below " + rounded(limits.adhesion) +
                  " m/s: a model, of smooth and clean surfaces");
  }
  if (made.speed < limits.rough && asperities_of(encounter) == 0.0) {
    all.push_back("faces are taken as smooth: below " + rounded(limits.rough) +
                  " m/s even asperities as low as those of a bearing ball (24 nm rms) count; give a roughness");
  }
  for (const Participant* each : {&encounter.first, &encounter.against}) {
    const std::string who = each == &encounter.first ? "of the first body" : "of what it meets";
    if (!has_loss(*each)) all.push_back("no loss in the material " + who + " is known: it is taken to lose nothing");
    if (!has_strength(*each))
      all.push_back("no yield strength " + who + " is known: it is taken not to yield or break");
  }
  for (const std::string& line : shell_warnings(encounter, made.speed)) all.push_back(line);
  for (const std::string& line : sound_warnings(encounter)) all.push_back(line);
  if (computed.finest.beyond_small_strain) {
    all.emplace_back("strains are large: linear elasticity, and so the computed channels, are no longer accurate");
  }
  if (!computed.converged) all.push_back("computed channels: " + computed.reason);
  return all;
}

}  // namespace stoss::prediction
