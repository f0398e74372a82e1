#include "encounter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "stoss/bodies/rod.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

/// What `make` returns; its refusals say that they are of what is met.
template <typename Make>
auto of_what_is_met(Make make) {
  try {
    return make();
  } catch (const InvalidInput& error) {
    throw InvalidInput(std::string("against ") + error.what());
  }
}

void require_si_keys(const Against& against) {
  const std::vector<std::string> disk{"young", "density", "radius"}, rod{"young", "density", "length", "area"};
  const auto& keys = against.kind == "rod" ? rod : disk;
  for (const std::string& key : keys) {
    if (against.values.contains(key)) continue;
    throw InvalidInput(fmt::format("against: got {} without {}, allowed all of {}, in SI as the first", against.kind,
                                   key, fmt::join(keys, ", ")));
  }
}

std::optional<Scales> si_scales(bool rods, const DiskArguments& disk, const std::optional<Rod>& rod) {
  if (!rods) return disk.si();
  return rod ? std::optional(scales(*rod)) : std::nullopt;
}

}  // namespace

Encounter::Encounter(bool rods, const DiskArguments& disk, const std::optional<Rod>& rod, Against against)
    : rods_(rods), disk_(disk), rod_(rod), si_(si_scales(rods, disk, rod)), against_(std::move(against)) {
  if (si_ && against_.kind == (rods_ ? "rod" : "disk")) require_si_keys(against_);
}

BodyMaker Encounter::first(double poisson) const { return rods_ ? rod(rod_.value_or(Rod{})) : stoss::disk(poisson); }

Rod Encounter::second_rod() const {
  return {against_.value("length", 1.0), against_.value("young", 1.0), against_.value("density", 1.0),
          against_.value("area", 1.0)};
}

Material Encounter::second_material() const {
  const auto& given = against_.values;
  return {given.at("young"), against_.value("poisson", disk_.poisson), given.at("density")};
}

Disk Encounter::second_disk(double poisson) const {
  if (!si_ || rods_) {
    return {against_.value("poisson", poisson), against_.value("radius", 1.0), against_.value("young", 1.0),
            against_.value("density", 1.0)};
  }
  const Scales other = scales(second_material(), disk_.chosen_plane(), against_.values.at("radius"));
  const auto modulus = [](const Scales& of) { return of.force / of.length; };
  return {stoss::plane_poisson(second_material(), disk_.chosen_plane()), other.length / si_->length,
          modulus(other) / modulus(*si_), against_.values.at("density") / *disk_.density};
}

BodyMaker Encounter::second(double poisson) const {
  if (against_.kind == "same") return first(poisson);
  return of_what_is_met([&]() -> BodyMaker {
    if (against_.kind == "disk") return stoss::disk(second_disk(poisson));
    return rod(second_rod());
  });
}

RefinableContact Encounter::refinable(double poisson) const {
  return against_.is_body() ? RefinableContact(first(poisson), second(poisson)) : RefinableContact(first(poisson));
}

Contact Encounter::contact(double poisson, double cutoff) const {
  if (against_.is_body()) return stoss::contact(first(poisson), second(poisson), cutoff);
  const ExponentialWall soft{against_.value("hardness", 500.0), against_.value("strength", 1.0)};
  const Wall wall = against_.kind == "wall" ? Wall(HardWall{}) : Wall(soft);
  of_what_is_met([&] { validate(wall); });
  return stoss::contact(rods_ ? rod(rod_.value_or(Rod{}), cutoff) : stoss::disk(poisson, cutoff), wall);
}

void Encounter::describe(nlohmann::ordered_json& inputs) const {
  inputs["body"] = rods_ ? "rod" : "disk";
  if (!rods_) disk_.describe(inputs);
  if (rod_) cli::describe(*rod_, inputs);
  inputs["against"] = against_.kind;
  if (against_.kind == "rod" && si_) {
    inputs["against_material_young[Pa]"] = second_rod().young;
    inputs["against_material_density[kg/m^3]"] = second_rod().density;
    inputs["against_length[m]"] = second_rod().length;
    inputs["against_area[m^2]"] = second_rod().area;
  } else if (against_.kind == "rod") {
    for (const char* key : {"length", "young", "density", "area"}) {
      inputs[std::string("against_") + key] = against_.value(key, 1.0);
    }
  } else if (against_.kind == "exponential") {
    inputs["against_hardness"] = against_.value("hardness", 500.0);
    inputs["against_strength"] = against_.value("strength", 1.0);
  } else if (against_.kind == "disk" && si_) {
    inputs["against_poisson"] = second_disk(0.0).poisson;
    inputs["against_material_young[Pa]"] = second_material().young;
    inputs["against_material_poisson"] = second_material().poisson;
    inputs["against_material_density[kg/m^3]"] = second_material().density;
    inputs["against_radius[m]"] = against_.values.at("radius");
  } else if (against_.kind == "disk") {
    const auto poisson = against_.values.find("poisson");
    inputs["against_poisson"] = poisson == against_.values.end() ? nlohmann::ordered_json("as the first")
                                                                 : nlohmann::ordered_json(poisson->second);
    for (const char* key : {"radius", "young", "density"}) {
      inputs[std::string("against_") + key] = against_.value(key, 1.0);
    }
  }
}

void EncounterArguments::add_to(CLI::App& to, const std::string& kind, const std::string& help) {
  command = &to;
  to.add_option("--body", body, "Kind of body (default: disk); a rod has no Poisson number")
      ->check(CLI::IsMember({"disk", "rod"}))
      ->type_name("BODY")
      ->group("Body");
  disk.add_material_to(to, material_group);
  rod.add_to(to);
  to.add_option("--against", against,
                "What the body meets (default: wall)\n"
                "  wall: a rigid wall; same: a second body, equal to the first\n"
                "  disk[,poisson=NU,radius=R,young=E,density=RHO]: a second disk,\n"
                "               in units of the first; with a material, in SI\n"
                "  rod[,length=L,young=E,density=RHO,area=A]: a second rod, likewise" +
                    help)
      ->type_name("{wall,same,disk,rod" + (kind.empty() ? "" : "," + kind) + "}[,KEY=NUMBER]...")
      ->group("Against");
}

Encounter EncounterArguments::encounter() const {
  const bool rods = body == "rod";
  if (!rods && command->get_option("--poisson")->count() == 0) throw CLI::RequiredError("--poisson");
  const std::vector<std::string> of_disks{"poisson", "radius", "plane"}, of_rods{"length", "area"};
  for (const std::string& name : rods ? of_disks : of_rods) {
    if (command->get_option("--" + name)->count() == 0) continue;
    throw InvalidInput(
        fmt::format("{0}: got --{0} with --body {1}, allowed only with --body {2}", name, body, rods ? "disk" : "rod"));
  }
  return {rods, disk, rods ? rod.si(disk) : std::nullopt, parse_against(against)};
}

}  // namespace stoss::cli
