#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "check.hpp"
#include "encounter/participant.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/relaxation/constant_quality.hpp"

namespace stoss {
namespace {

void require_one(const Losses& its) {
  std::string names;
  int count = 0;
  for (const auto& [name, is_there] :
       {std::pair{"relaxation", !its.relaxation.terms.empty()}, std::pair{"quality", its.quality != 0.0},
        std::pair{"loss_time", its.loss_time != 0.0}}) {
    if (is_there) names += (count++ == 0 ? "" : " beside a ") + std::string(name);
  }
  if (count < 2) return;
  throw InvalidInput::out_of_range(names.substr(0, names.find(' ')), "a " + names, "one of them",
                                   "each says by itself how the material loses energy");
}

Losses of_material(const Material& its) {
  Losses made{its.loss_time.value_or(0.0), its.quality.value_or(0.0), its.frequency,
              its.relaxation.value_or(Relaxation{})};
  require_one(made);
  return made;
}

/// Those that are given beside the material, if any.
std::optional<Losses> own_losses(const Participant& of) {
  const double loss_time = given_or(of, "loss_time", 0.0), quality = given_or(of, "quality", 0.0);
  if (!of.values.contains("loss_time") && !of.values.contains("quality") && !of.relaxation) return std::nullopt;
  const double frequency = of.material ? of.material->frequency : usual_frequency;
  const Losses made{loss_time, quality, frequency, of.relaxation.value_or(Relaxation{})};
  require_one(made);
  return made;
}

void require_valid(const Participant& of, const Losses& its) {
  validate(its.relaxation);
  require("frequency", its.frequency, {1e-30, 1e30, true, true, "above 0, 1e-30 to 1e30"}, "of a modulus, rad/s");
  if (its.quality != 0.0) (void)constant_quality(its.quality, lowest_of_body, highest_of_body);
  if (!of.rigid) return;
  constexpr const char* none = "which loses nothing";
  if (!its.relaxation.terms.empty()) {
    throw InvalidInput::out_of_range("relaxation", text_of(its.relaxation),
                                     "none of a rigid body, " + std::string(none));
  }
  for (const auto& [name, value] : {std::pair{"quality", its.quality}, std::pair{"loss_time", its.loss_time}}) {
    if (value != 0.0) throw InvalidInput::out_of_range(name, shown(value), "0 of a rigid body, " + std::string(none));
  }
}

/// E, or of a disk in plane strain E/(1 − ν²).
double modulus_of(const Participant& of) {
  const Material& its = *of.material;
  const bool strain = kind(of.kind).has_plane && of.plane == Plane::strain;
  return strain ? its.young / (1.0 - its.poisson * its.poisson) : its.young;
}

}  // namespace

Losses losses_of(const Participant& of) { return losses_of_layers(of).front(); }

std::vector<Losses> losses_of_layers(const Participant& of) {
  const std::size_t count = of.below.size() + 1;
  if (const auto own = own_losses(of)) {
    require_valid(of, *own);
    std::vector<Losses> all(count, *own);
    return all;
  }
  if (of.rigid) return std::vector<Losses>(count);
  std::vector<Losses> all;
  const auto add = [&](const Participant& layer) {
    const Losses its = layer.material ? of_material(*layer.material) : Losses{};
    require_valid(of, its);
    all.push_back(its);
  };
  add(of);
  for (const Participant& layer : of.below) {
    try {
      add(layer);
    } catch (const InvalidInput& error) {
      throw error.within("layer " + std::to_string(all.size() + 1));
    }
  }
  return all;
}

bool layers_differ(const Participant& of) {
  const std::vector<Losses> all = losses_of_layers(of);
  return std::any_of(all.begin(), all.end(), [&](const Losses& its) { return its != all.front(); });
}

bool relaxes(const Participant& of) {
  const std::vector<Losses> all = losses_of_layers(of);
  return std::any_of(all.begin(), all.end(),
                     [](const Losses& its) { return its.quality != 0.0 || !its.relaxation.terms.empty(); });
}

void refuse_relaxing(const Encounter& encounter, const std::string& what) {
  const auto refuse = [&what](const Participant& of) {
    if (relaxes(of)) {
      throw InvalidInput::conflict(losses_of(of).quality != 0.0 ? "quality" : "relaxation",
                                   what + " knows no material that relaxes", "give a loss_time; 0: no loss");
    }
    if (layers_differ(of)) {
      throw InvalidInput::conflict("loss_time", what + " knows one for all layers of a " + of.kind,
                                   "give it; 0: no loss");
    }
  };
  refuse(encounter.first);
  with_prefix_against([&] { refuse(encounter.against); });
}

std::vector<double> stiffening(const Participant& of, double size) {
  const std::vector<Losses> all = losses_of_layers(of);
  std::vector<double> factors(all.size(), 1.0);
  if (!of.material || of.rigid) return factors;
  const double own = given_or(of, "radius", given_or(of, "length", size));
  const double speed = std::sqrt(modulus_of(of) / of.material->density);
  const auto at = [&](const Losses& its, double frequency) {
    return instantaneous(constant_quality(its.quality, lowest_of_body, highest_of_body), its.quality, frequency);
  };
  const auto of_first = [&](const Losses& its) {
    if (its.quality == 0.0) return 1.0;
    // The band is in c/R of E(0). With Ω of E(ω) in place of it, s = E(0)/E(ω) = f(Ω/√s) = f(Ω) s^(a/2), as f ∝ Ω^−a.
    const double power = 2.0 / std::numbers::pi * std::atan(1.0 / its.quality);
    return std::pow(at(its, its.frequency * own / speed), 1.0 / (1.0 - 0.5 * power));
  };
  factors.front() = of_first(all.front());
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Losses& its = all[i];
    if (its == all.front()) {
      factors[i] = factors.front();
    } else if (its.quality != 0.0) {  // in c/R of the first layer, as all of them
      factors[i] = at(its, its.frequency * own / (speed * std::sqrt(factors.front())));
    }
  }
  return factors;
}

double instantaneous_of_relaxed(double relaxed, const Relaxation& relaxation) {
  if (relaxation.terms.empty()) {
    throw InvalidInput::conflict("young_is", "there is no relaxation", "leave it out, or give one");
  }
  constexpr double rounding = 1e-12;
  if (relaxation.relaxed() <= rounding) {
    throw InvalidInput::out_of_range("young_is", "relaxed, with shares of 1 in sum", "instantaneous",
                                     "E_inf is 0: nothing is left of the modulus");
  }
  return relaxed / relaxation.relaxed();
}

void take_young_as_relaxed(Participant& of) {
  const Relaxation its =
      of.relaxation.value_or(of.material ? of.material->relaxation.value_or(Relaxation{}) : Relaxation{});
  validate(its);
  const auto take = [&its](Participant& one) {
    double& young = one.material ? one.material->young : one.values.try_emplace("young", 1.0).first->second;
    young = instantaneous_of_relaxed(young, its);
    one.material_name.clear();
  };
  take(of);
  for (Participant& layer : of.below) take(layer);
}

std::vector<std::string> sound_warnings(const Encounter& encounter) {
  std::vector<std::string> lines;
  for (const Participant* each : {&encounter.first, &encounter.against}) {
    const NamedMaterial* its = named_of(*each);
    if (its == nullptr || !its->sound || each->rigid || own_losses(*each)) continue;
    std::string line =
        std::string(its->name) +
        " is taken as sound, smooth, dry and uncracked: measured losses are often ten times as large and more";
    if (lines.empty() || lines.front() != line) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace stoss
