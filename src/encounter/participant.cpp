#include "encounter/participant.hpp"

#include <string>

#include "check.hpp"

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

}  // namespace

double given_or(const Participant& of, std::string_view name, double otherwise) {
  const auto found = of.values.find(name);
  return found == of.values.end() ? otherwise : found->second;
}

double loss_time_of(const Participant& of) {
  const bool of_material = of.material && !of.rigid;
  return given_or(of, "loss_time", of_material ? of.material->loss_time.value_or(0.0) : 0.0);
}

Values all_values(const Participant& of, std::optional<double> poisson, double radius) {
  const Kind& kind = stoss::kind(of.kind);
  for (const auto& [name, value] : of.values) {
    if (const Parameter* its = parameter(kind, name); its == nullptr) {
      throw InvalidInput(name + ": got a number, allowed none of a " + std::string(kind.name));
    } else if (its->of_material && of.material) {
      throw InvalidInput(name + ": got " + shown(value) + " beside a material, allowed one of the two");
    }
  }
  Values all;
  for (const Parameter& each : kind.parameters) {
    const std::string name(each.name);
    if (each.of_material && of.material) {
      all[name] = of_material(of, kind, name, given_or(of, "radius", radius));
    } else if (name == "loss_time") {
      all[name] = loss_time_of(of);
    } else if (const auto found = of.values.find(name); found != of.values.end()) {
      all[name] = found->second;
    } else if (of.material) {
      throw InvalidInput(name + ": got none, allowed a number in " + std::string(each.unit) + " (with a material)");
    } else if (name == "poisson" && poisson) {
      all[name] = *poisson;
    } else if (each.otherwise) {
      all[name] = *each.otherwise;
    } else {
      throw InvalidInput(name + ": got none, allowed a number (" + std::string(each.help) + ")");
    }
  }
  return all;
}

}  // namespace stoss
