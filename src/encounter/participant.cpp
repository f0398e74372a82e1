#include "encounter/participant.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "check.hpp"
#include "encounter/shells.hpp"
#include "stoss/encounter/roughness.hpp"

namespace stoss {
namespace {

/// Modulus of a disk as its scales have it: E, or E/(1 − ν²) in plane strain.
double plane_modulus(const Participant& of, double radius) {
  const Scales its = scales(*of.material, of.plane, radius);
  return its.force / its.length;
}

/// A number that the material gives. @param radius of a disk
double of_material(const Participant& of, const Kind& kind, std::string_view name, double radius) {
  if (name == "poisson") return kind.has_plane ? plane_poisson(*of.material, of.plane) : of.material->poisson;
  if (name == "density") return of.material->density;
  return kind.has_plane ? plane_modulus(of, radius) : of.material->young;
}

[[noreturn]] void refuse_in_layer(const std::string& layer, std::string_view name, const Participant& of) {
  throw InvalidInput::conflict(layer + std::string(name), "one holds for the whole " + of.kind,
                               "give it with the first layer");
}

void require_layers(const Participant& of, const Kind& kind) {
  const std::size_t most = kind.add_layer ? most_layers : 1;
  if (of.below.size() >= most) {
    throw InvalidInput::out_of_range("layers", std::to_string(of.below.size() + 1),
                                     "1" + (most > 1 ? " to " + std::to_string(most) : "") + " of a " + of.kind);
  }
  for (std::size_t i = 0; i < of.below.size(); ++i) {
    const std::string layer = "layer " + std::to_string(i + 2) + " ";
    for (const Parameter& each : kind.parameters) {
      if (is_of_whole(each.name) && of.below[i].values.contains(each.name)) refuse_in_layer(layer, each.name, of);
    }
    if (of.below[i].relaxation) refuse_in_layer(layer, "relaxation", of);
    if (of.below[i].material.has_value() != of.material.has_value()) {
      if (of.material) {
        throw InvalidInput::missing(layer + "material", "", "the first layer has one, so all need one");
      }
      throw InvalidInput::conflict(layer + "material", "the first layer has none, so none can have one");
    }
  }
}

/// Refuses materials and sizes in SI so far from any that units made of them overflow.
void require_in_si(const Participant& of, const Kind& kind) {
  if (!of.material) return;
  (void)plane_poisson(*of.material, of.plane);  // refuses the material
  constexpr Range any{1e-30, 1e30, true, true, "1e-30 to 1e30"};
  for (const Parameter& each : kind.parameters) {
    const double size = each.unit == "m" && !is_of_face(each.name) ? given_or(of, each.name, 1.0) : 1.0;
    if (size > 0.0 && std::isfinite(size)) require(each.name, size, any, "in m");
  }
}

/// Its size and material, which what it meets is given in.
Values values_of_file(const Participant& of) {
  if (!of.modal) throw InvalidInput::conflict("body", "a " + of.kind + " body needs its modes, from a body file");
  for (const auto& [name, value] : of.values) {
    if (!is_of_face(name)) throw InvalidInput::conflict(name, "the body file has it already", "leave it out");
  }
  (void)asperities_of(of);
  const ModalBody& its = *of.modal;
  return {{"radius", own_length(its)},
          {"poisson", its.poisson},
          {"young", its.young},
          {"density", its.density},
          {"loss_time", its.loss_time}};
}

/// All of them, with the modulus of the material at its frequency, E(0) without one.
Values values_at_frequency(const Participant& of, std::optional<double> poisson, double radius) {
  const Kind& kind = stoss::kind(of.kind);
  for (const auto& [name, value] : of.values) {
    if (const Parameter* its = parameter(kind, name); its == nullptr) {
      throw InvalidInput::conflict(name, "a " + std::string(kind.name) + " has none", "leave it out");
    } else if (its->of_material && of.material) {
      throw InvalidInput::conflict(name, "the material has it already",
                                   "leave out " + shown(value) + ", or the material");
    }
  }
  require_in_si(of, kind);
  if (!kind.wall) (void)asperities_of(of);
  Values all;
  for (const Parameter& each : kind.parameters) {
    const std::string name(each.name);
    if (each.of_material && of.material) {
      all[name] = of_material(of, kind, name, given_or(of, "radius", radius));
    } else if (is_loss(name)) {
      const Losses its = losses_of(of);
      all[name] = name == "quality" ? its.quality : its.loss_time;
    } else if (is_of_whole(name)) {
      all[name] = given_or(of, name, 0.0);
    } else if (const auto found = of.values.find(name); found != of.values.end()) {
      all[name] = found->second;
    } else if (of.material && !is_shape(each)) {
      throw InvalidInput::missing(name, "", "a material needs it too, in " + std::string(each.unit));
    } else if (of.rigid && name == "poisson") {
      all[name] = units_of_rigid.at("poisson");
    } else if (name == "poisson" && poisson) {
      all[name] = *poisson;
    } else if (each.default_value) {
      all[name] = *each.default_value;
    } else {
      throw InvalidInput::missing(name, "a number", std::string(each.help));
    }
  }
  return all;
}

}  // namespace

Participant modal_participant(ModalBody body) {
  Participant made = of_kind("modal");
  made.material = Material{.young = body.young, .poisson = body.poisson, .density = body.density};
  made.material->loss_time = body.loss_time;
  made.modal = std::make_shared<const ModalBody>(std::move(body));
  return made;
}

double given_or(const Participant& of, std::string_view name, double otherwise) {
  const auto found = of.values.find(name);
  return found == of.values.end() ? otherwise : found->second;
}

double size_of_first(const Encounter& encounter) {
  const Participant& first = encounter.first;
  if (first.modal) return own_length(*first.modal);
  return given_or(first, "radius", given_or(first, "length", 1.0));
}

double loss_time_of(const Participant& of) { return losses_of(of).loss_time; }

const NamedMaterial* named_of(const Participant& of) {
  for (const NamedMaterial& each : named_materials()) {
    if (each.name == of.material_name) return &each;
  }
  return nullptr;
}

double inverse_mass_of_solid(const Participant& of) {
  if (of.modal) return of.modal->held ? 0.0 : 1.0 / of.modal->mass;
  const double curvature = 1.0 / given_or(of, "radius", std::numeric_limits<double>::infinity());
  return 3.0 / (4.0 * std::numbers::pi * of.material->density) * std::pow(curvature, 3) / share_of_mass(of);
}

double inverse_mass_of(const Participant& of) {
  const double solid = inverse_mass_of_solid(of);
  return solid / (1.0 + given_or(of, "extra_mass", 0.0) * solid);
}

double softness_of(const Participant& of) {
  const Material& its = *of.material;
  return of.rigid ? 0.0 : (1.0 - its.poisson * its.poisson) / its.young;
}

Values all_values(const Participant& of, std::optional<double> poisson, double radius) {
  const Kind& kind = stoss::kind(of.kind);
  if (kind.from_file) return values_of_file(of);
  require_layers(of, kind);
  Values all = values_at_frequency(of, poisson, radius);
  if (const auto young = all.find("young"); young != all.end()) young->second *= stiffening(of, radius).front();
  return all;
}

std::vector<Values> values_below(const Participant& of, std::optional<double> poisson, double radius) {
  std::vector<Values> all;
  if (of.below.empty()) return all;
  const std::vector<double> stiffer = stiffening(of, radius);
  for (const Participant& each : of.below) {
    Participant layer{.kind = of.kind, .values = each.values, .material = each.material, .plane = of.plane};
    const bool last = &each == &of.below.back();
    try {
      if (last) layer.values.try_emplace("thickness", std::numeric_limits<double>::infinity());
      if (!layer.values.contains("thickness")) {
        throw InvalidInput::missing("thickness", "", "only the last layer may have none: it has no end");
      }
      all.push_back(values_at_frequency(layer, poisson, radius));
      all.back().at("young") *= stiffer[all.size()];
    } catch (const InvalidInput& error) {
      throw error.within("layer " + std::to_string(all.size() + 2));
    }
  }
  return all;
}

}  // namespace stoss
