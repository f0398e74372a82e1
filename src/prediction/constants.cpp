#include "prediction/constants.hpp"

#include <algorithm>
#include <functional>

#include "check.hpp"
#include "encounter/participant.hpp"
#include "prediction/touching.hpp"
#include "quasistatic/lossy_motion.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/errors.hpp"

namespace stoss::prediction {
namespace {

constexpr Range range{0.0, 10.0, true, true, "0 to 10"};

void multiply(std::optional<double>& number, double factor) {
  if (number) *number *= factor;
}

/// A constant of a material: what makes it larger, and whether an elastic or lossy impact feels it.
struct Constant {
  std::string_view name;
  double Uncertainties::*known;
  std::function<void(Material&, double factor)> enlarge;
  bool elastic;
};

const std::vector<Constant>& constants() {
  static const std::vector<Constant> all{
      {"young", &Uncertainties::young, [](Material& its, double factor) { its.young *= factor; }, true},
      {"poisson", &Uncertainties::poisson,
       [](Material& its, double factor) { its.poisson = std::min(its.poisson * factor, 0.4999); }, true},
      {"density", &Uncertainties::density, [](Material& its, double factor) { its.density *= factor; }, true},
      {"loss_time", &Uncertainties::loss_time, [](Material& its, double factor) { multiply(its.loss_time, factor); },
       false},
      {"yield_strength", &Uncertainties::yield_strength,
       [](Material& its, double factor) { multiply(its.yield_strength, factor); }, false},
      {"surface_energy", &Uncertainties::surface_energy,
       [](Material& its, double factor) { multiply(its.surface_energy, factor); }, false},
  };
  return all;
}

Uncertainties known_of(const Participant& of) {
  const NamedMaterial* its = named_of(of);
  return its != nullptr ? its->uncertainties : Uncertainties{};
}

/// By what the loss time of a slow impact is larger where the material loses more by a factor.
double larger_loss_time(const Participant& of, double factor) {
  const double quality = quality_of(of);
  return quality == 0.0
             ? factor
             : quasistatic::loss_number_of_quality(quality / factor) / quasistatic::loss_number_of_quality(quality);
}

/// What a body adds to the loss in the material of slow contacts: its softness times its loss time.
double loss_of(const Participant& of) { return of.material ? softness_of(of) * loss_time_of(of) : 0.0; }

/// Layers of a plate keep theirs: only the top one varies.
Participant enlarged(Participant of, const Constant& constant, double factor) {
  constant.enlarge(*of.material, factor);
  of.material_name.clear();
  return of;
}

std::string allowed_names(const Encounter& encounter) {
  std::string names = "work_of_adhesion";
  for (const std::string before : {"", "against."}) {
    if (!before.empty() && !encounter.against.material) continue;
    for (const Constant& each : constants()) names += ", " + before + std::string(each.name);
  }
  return names;
}

void require_names(const Encounter& encounter, const PredictionOptions& options) {
  for (const auto& [name, uncertainty] : options.uncertainties) {
    const bool other = name.starts_with("against.");
    const std::string_view constant = std::string_view(name).substr(other ? 8 : 0);
    const bool known =
        (name == "work_of_adhesion") || ((!other || encounter.against.material) &&
                                         std::any_of(constants().begin(), constants().end(),
                                                     [&](const Constant& each) { return each.name == constant; }));
    if (!known) {
      throw InvalidInput::out_of_range("uncertainties", "'" + name + "'", allowed_names(encounter));
    }
    require("uncertainties " + name, uncertainty, range, "the constant is known within a factor of 1 + this");
  }
}

}  // namespace

Encounter at_speed(const Encounter& encounter, double time) {
  Encounter made = encounter;
  for (Participant* each : {&made.first, &made.against}) {
    const double quality = quality_of(*each);
    if (quality == 0.0) continue;
    each->material->loss_time = quasistatic::loss_number_of_quality(quality) / 1.5 * time;
    for (Participant& layer : each->below) {  // of one material, as all layers share a loss time
      layer.material->loss_time = each->material->loss_time;
      layer.material_name.clear();
    }
    each->material_name.clear();
  }
  return made;
}

std::vector<Variant> variants(const Encounter& encounter, const Encounter& at, const PredictionOptions& options) {
  require_names(encounter, options);
  std::vector<Variant> made;
  const double of_all = loss_of(at.first) * (at.against.kind == "same" ? 2.0 : 1.0) + loss_of(at.against);
  const auto uncertainty_of = [&](const std::string& name, double otherwise) {
    const auto given = options.uncertainties.find(name);
    return given == options.uncertainties.end() ? otherwise : given->second;
  };
  const auto add = [&](Participant Encounter::*side, const std::string& before) {
    if (!(encounter.*side).material) return;
    const Uncertainties known = known_of(encounter.*side);
    for (const Constant& each : constants()) {
      const std::string name = before + std::string(each.name);
      const double uncertainty = uncertainty_of(name, known.*each.known);
      if (uncertainty == 0.0) continue;
      Variant variant{name, uncertainty, at, options.work_of_adhesion, each.elastic};
      if (each.name == "loss_time") {
        if (of_all == 0.0) continue;
        const double share = loss_of(at.*side) / of_all;
        const double more = larger_loss_time(encounter.*side, 1.0 + uncertainty) - 1.0;
        variant.material_factor += more * share * (at.against.kind == "same" ? 2.0 : 1.0);
      } else {
        variant.encounter.*side = enlarged(at.*side, each, 1.0 + uncertainty);
        // Of two alike the weaker one is no other: both are what they are made of.
        const bool alike =
            !encounter.first.material_name.empty() && encounter.first.material_name == encounter.against.material_name;
        if (alike && each.name == "yield_strength") {
          if (!before.empty()) continue;
          variant.encounter.against = enlarged(at.against, each, 1.0 + uncertainty);
        }
      }
      made.push_back(std::move(variant));
    }
  };
  add(&Encounter::first, "");
  add(&Encounter::against, "against.");
  const double of_work = uncertainty_of("work_of_adhesion", 0.0);
  if (of_work > 0.0 && options.work_of_adhesion) {
    made.push_back({"work_of_adhesion", of_work, at, *options.work_of_adhesion * (1.0 + of_work), false});
  }
  return made;
}

}  // namespace stoss::prediction
