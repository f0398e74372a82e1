#include "prediction/constants.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "check.hpp"
#include "encounter/participant.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/encounter/roughness.hpp"
#include "stoss/errors.hpp"

namespace stoss::prediction {
namespace {

constexpr double least_quality = 3.0;  // of constant_quality
constexpr Range range{0.0, 10.0, true, true, "0 to 10"};

void multiply(std::optional<double>& number, double factor) {
  if (number) *number *= factor;
}

/// Shares whose E_j are larger by a factor, E∞ being as it is: E″ is larger by the factor at all frequencies.
void relax_more(Relaxation& its, double& young, double factor) {
  double growth = 1.0;
  for (const RelaxationTerm& term : its.terms) growth += (factor - 1.0) * term.share;
  for (RelaxationTerm& term : its.terms) term.share *= factor / growth;
  young *= growth;
}

/// 1/Q is larger by a factor, wherever it is given; a quality is no lower than there are such materials.
void lose_more(Participant& of, double factor) {
  Material& its = *of.material;
  if (of.relaxation) relax_more(*of.relaxation, its.young, factor);
  if (const auto own = of.values.find("loss_time"); own != of.values.end()) own->second *= factor;
  if (const auto own = of.values.find("quality"); own != of.values.end() && own->second > 0.0) {
    own->second = std::max(own->second / factor, least_quality);
  }
  if (its.loss_time) *its.loss_time *= factor;
  if (its.quality) its.quality = std::max(*its.quality / factor, least_quality);
  if (its.relaxation && !of.relaxation) relax_more(*its.relaxation, its.young, factor);
  for (Participant& layer : of.below) {
    lose_more(layer, factor);
    layer.material_name.clear();
  }
}

/// A constant of a material: what makes it larger, and whether it belongs to the computed channels.
struct Constant {
  std::string_view name;
  double Uncertainties::*known;
  std::function<void(Participant&, double factor)> enlarge;
  bool computed;
};

const std::vector<Constant>& constants() {
  static const std::vector<Constant> all{
      {"young", &Uncertainties::young, [](Participant& its, double factor) { its.material->young *= factor; }, true},
      {"poisson", &Uncertainties::poisson,
       [](Participant& its, double factor) {
         its.material->poisson = std::min(its.material->poisson * factor, 0.4999);
       },
       true},
      {"density", &Uncertainties::density, [](Participant& its, double factor) { its.material->density *= factor; },
       true},
      {"loss", &Uncertainties::loss, [](Participant& its, double factor) { lose_more(its, factor); }, true},
      {"yield_strength", &Uncertainties::yield_strength,
       [](Participant& its, double factor) {
         multiply(its.material->yield_strength, factor);
         if (const auto own = its.values.find("yield_strength"); own != its.values.end()) own->second *= factor;
       },
       true},
      {"surface_energy", &Uncertainties::surface_energy,
       [](Participant& its, double factor) { multiply(its.material->surface_energy, factor); }, false},
  };
  return all;
}

Uncertainties known_of(const Participant& of) {
  const NamedMaterial* its = named_of(of);
  return its != nullptr ? its->uncertainties : Uncertainties{};
}

bool loses_energy(const Participant& of) {
  const std::vector<Losses> all = losses_of_layers(of);
  return std::any_of(all.begin(), all.end(),
                     [](const Losses& its) { return its != Losses{.frequency = its.frequency}; });
}

/// A body by its modes with another modulus, density or loss: the same numbers in a unit that is smaller by the factor.
void enlarge_modal(Participant& of, std::string_view constant, double factor) {
  ModalBody its = *of.modal;
  if (constant == "young") its = in_units(its, 1.0, 1.0 / factor, 1.0);
  if (constant == "density") its = in_units(its, 1.0, 1.0, 1.0 / factor);
  if (constant == "loss") its.loss_time *= factor;
  of.modal = std::make_shared<const ModalBody>(std::move(its));
}

/// What ν would do to modes is not known of a body that has nothing else.
bool is_constant_of(const Participant& of, const Constant& constant) { return !of.modal || constant.name != "poisson"; }

/// Layers of a plate keep theirs, but for the loss: only the top one varies.
Participant enlarged(Participant of, const Constant& constant, double factor) {
  constant.enlarge(of, factor);
  if (of.modal) enlarge_modal(of, constant.name, factor);
  of.material_name.clear();
  return of;
}

/// u of a roughness, which is that of the factor from it to u₀.
constexpr double of_roughness = asperities_over_rms_error / asperities_over_rms;

bool has_roughness(const Participant& of) { return given_or(of, "roughness", 0.0) > 0.0; }

std::string allowed_names(const Encounter& encounter) {
  std::string names = "work_of_adhesion";
  for (const std::string before : {"", "against."}) {
    if (!before.empty() && !encounter.against.material) continue;
    for (const Constant& each : constants()) {
      const Participant& of = before.empty() ? encounter.first : encounter.against;
      if (is_constant_of(of, each)) names += ", " + before + std::string(each.name);
    }
  }
  for (const std::string before : {"", "against."}) {
    if (has_roughness(before.empty() ? encounter.first : encounter.against)) names += ", " + before + "roughness";
  }
  return names;
}

void require_names(const Encounter& encounter, const PredictionOptions& options) {
  for (const auto& [name, uncertainty] : options.uncertainties) {
    const bool other = name.starts_with("against.");
    const std::string_view constant = std::string_view(name).substr(other ? 8 : 0);
    const bool known = (name == "work_of_adhesion") ||
                       (constant == "roughness" && has_roughness(other ? encounter.against : encounter.first)) ||
                       ((!other || encounter.against.material) &&
                        std::any_of(constants().begin(), constants().end(), [&](const Constant& each) {
                          const Participant& of = other ? encounter.against : encounter.first;
                          return each.name == constant && is_constant_of(of, each);
                        }));
    if (!known) {
      throw InvalidInput::out_of_range("uncertainties", "'" + name + "'", allowed_names(encounter));
    }
    require("uncertainties " + name, uncertainty, range, "the constant is known within a factor of 1 + this");
  }
}

}  // namespace

std::vector<Variant> variants(const Encounter& encounter, const PredictionOptions& options) {
  require_names(encounter, options);
  std::vector<Variant> made;
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
      if (uncertainty == 0.0 || !is_constant_of(encounter.*side, each)) continue;
      if (each.name == "loss" && !loses_energy(encounter.*side)) continue;
      Variant variant{name, uncertainty, encounter, options.work_of_adhesion, each.computed};
      variant.encounter.*side = enlarged(encounter.*side, each, 1.0 + uncertainty);
      // Of two alike the weaker one is no other: both are what they are made of.
      const bool alike =
          !encounter.first.material_name.empty() && encounter.first.material_name == encounter.against.material_name;
      if (alike && each.name == "yield_strength") {
        if (!before.empty()) continue;
        variant.encounter.against = enlarged(encounter.against, each, 1.0 + uncertainty);
      }
      made.push_back(std::move(variant));
    }
  };
  const auto add_roughness = [&](Participant Encounter::*side, const std::string& name) {
    if (!has_roughness(encounter.*side)) return;
    const double uncertainty = uncertainty_of(name, of_roughness);
    if (uncertainty == 0.0) return;
    made.push_back({name, uncertainty, encounter, options.work_of_adhesion, true});
    (made.back().encounter.*side).values.at("roughness") *= 1.0 + uncertainty;
  };
  add(&Encounter::first, "");
  add_roughness(&Encounter::first, "roughness");
  add(&Encounter::against, "against.");
  add_roughness(&Encounter::against, "against.roughness");
  const double of_work = uncertainty_of("work_of_adhesion", 0.0);
  if (of_work > 0.0 && options.work_of_adhesion) {
    made.push_back({"work_of_adhesion", of_work, encounter, *options.work_of_adhesion * (1.0 + of_work), false});
  }
  return made;
}

}  // namespace stoss::prediction
