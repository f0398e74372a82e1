#include "input/encounter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <iterator>

#include "app.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

std::vector<std::string> sizes_of(const Kind& its) {
  std::vector<std::string> names;
  for (const Parameter& each : its.parameters) {
    if (!each.of_material && !is_of_whole(each.name) && !is_shape(each)) names.emplace_back(each.name);
  }
  return names;
}

/// The sizes of kinds, those with the same sizes together.
std::string heading(const std::vector<std::string>& kinds) {
  std::vector<std::string> said;
  for (std::size_t k = 0; k < kinds.size();) {
    const auto sizes = sizes_of(kind(kinds[k]));
    std::vector<std::string> alike;
    for (; k < kinds.size() && sizes_of(kind(kinds[k])) == sizes; ++k) alike.push_back(kinds[k]);
    said.push_back(fmt::format("{} ({})", fmt::join(sizes, ", "), fmt::join(alike, ", ")));
  }
  return fmt::format("Material in SI (all or none of young, density and {})", fmt::join(said, " or "));
}

/// The unit as a placeholder: PA, KG/M^3.
std::string upper(std::string_view unit) {
  std::string text(unit);
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

void BodyOptions::add_poisson_to(CLI::App& command) {
  add(command, "--poisson", numbers_["poisson"],
      "Poisson's ratio, -0.95 to 0.995 of a disk, to 0.4999 of a sphere; with\na material: of the solid", "NU", "Body");
}

void BodyOptions::add_kind_to(CLI::App& command, const std::vector<std::string>& kinds, bool files) {
  kinds_ = kinds;
  std::string help = "Kind of body (default: sphere)";
  for (const std::string& name : kinds) {
    if (parameter(kind(name), "poisson") == nullptr) help += ". A " + name + " has no Poisson's ratio";
  }
  for (const std::string& name : kinds) {
    for (const Parameter& each : kind(name).parameters) {
      if (is_shape(each))
        add(command, "--" + std::string(each.name), numbers_[std::string(each.name)],
            fmt::format("{} (of a {}), {} to {}", each.help, name, each.low, each.high), "NUMBER", "Body");
    }
  }
  if (!files) {
    add_choice(command, "--body", kind_, kinds, help, "BODY", "Body");
    return;
  }
  const auto one_of = [choices = CLI::IsMember(kinds)](std::string& text) {
    return names_file(text) ? std::string() : choices(text);
  };
  command.add_option("--body", kind_, help + "; @FILE: any\nbody by its modes at a point")
      ->check(CLI::Validator(one_of, CLI::IsMember(kinds).get_description()))
      ->type_name("BODY")
      ->group("Body");
}

void BodyOptions::add_dynamics_to(CLI::App& command) {
  command
      .add_flag("--rigid-body", rigid_,
                "The body is rigid and keeps its mass. It needs no modulus, which cancels,\n"
                "and must meet something that deforms")
      ->group("Body");
  add(command, "--loss-time", numbers_["loss_time"],
      "Loss time eta of the body: stress = (1 + eta d/dt) elastic stress\n(default: 0, or that of --material); "
      "in R/c, with a material in s",
      "ETA", "Body");
  add(command, "--quality", numbers_["quality"],
      "In place of it: quality Q of the material, the same at all frequencies,\n3 to 1e9", "Q", "Body");
  add(command, "--relaxation", relaxation_,
      "In place of it: shares of the modulus E(0) that relax, and their times,\nas in 0.5:1+0.2:10; times in R/c, "
      "with a material in s",
      "SHARE:TIME+...", "Body");
  add_choice(command, "--young-is", young_is_, {"instantaneous", "relaxed"},
             "With --relaxation: the modulus that is given is E(0) (instantaneous),\nor what is left of it after all "
             "relaxation (default: instantaneous)",
             "WHICH", "Body");
  add(command, "--extra-mass", numbers_["extra_mass"],
      "Mass fixed to a sphere that moves as it does on average, as of a hammer\n(default: 0); in density radius^3, "
      "with a material in kg",
      "M", "Body");
  add(command, "--roughness", numbers_["roughness"],
      "rms height of the elastic asperities of its face, in R, with a material\nin m (default: 0, smooth): their "
      "length "
      "u0 is 0.45 of it (+- 0.05)",
      "RMS", "Body");
  add(command, "--u0", numbers_["u0"], "In place of it: their length, as in pressure = p0 exp(-gap/u0)", "U0", "Body");
  add(command, "--coat", numbers_["coat"],
      "Thickness of a soft layer on its face, thin beside the contact\n(default: 0, none); in R, with a material in m",
      "H", "Body");
  add(command, "--coat-young", numbers_["coat_young"],
      "Young's modulus of the coat, in that of the body, with a material in Pa", "E", "Body");
  add(command, "--coat-poisson", numbers_["coat_poisson"], "Poisson's ratio of the coat (default: 0.3)", "NU", "Body");
  add(command, "--coat-quality", numbers_["coat_quality"],
      "Quality Q of the coat, the same at all frequencies (default: no loss)", "Q", "Body");
  add(command, "--yield-strength", numbers_["yield_strength"],
      "Yield strength of a sphere, from which on it yields: a model (default: 0,\nelastic); in its "
      "modulus, with a material in Pa",
      "Y", "Body");
  add(command, "--yield-hardening", numbers_["yield_hardening"],
      "By how much it grows for each unit of plastic strain, up to 0.03 of the\nmodulus (default: 0)", "H", "Body");
  add(command, "--yield-rate", numbers_["yield_rate"],
      "C of the strength at a rate of strain in 1/s, Y (1 + C ln(rate)):\na model (default: 0); with a material", "C",
      "Body");
}

void BodyOptions::add_material_to(CLI::App& command) {
  const std::string group = heading(kinds_);
  add(command, "--material", material_,
      "A material of the list in place of --young, --density, --poisson:\nbearing steel, glass, ice, ... (stoss "
      "materials)",
      "NAME", group);
  std::vector<std::string> added{"poisson"};
  for (const std::string& owner : kinds_) {
    for (const Parameter& each : kind(owner).parameters) {
      const std::string name(each.name);
      if (is_of_whole(name) || is_shape(each) || std::find(added.begin(), added.end(), name) != added.end()) continue;
      added.push_back(name);
      const std::string more = name == "young" ? "; makes speeds m/s and adds SI values" : "";
      add(command, "--" + name, numbers_[name], fmt::format("{} in {}{}", each.help, each.unit, more), upper(each.unit),
          group);
    }
  }
  add(command, "--c-p", c_p_, "In place of --young and --poisson: speed of longitudinal waves in a solid in m/s", "M/S",
      group);
  add(command, "--c-s", c_s_, "With it: speed of transverse waves in m/s", "M/S", group);
  add_choice(command, "--plane", plane_, {"stress", "strain"},
             "Shape of a disk: thin (stress) or a long cylinder (strain); default: stress", "PLANE", group);
}

/// Refuses options that belong to other kinds.
void BodyOptions::require_own(const Kind& its) const {
  const auto require = [&](std::string option, bool is_given, const auto& has) {
    if (!is_given || has(its)) return;
    std::replace(option.begin(), option.end(), '_', '-');
    std::vector<std::string> owners = kinds_;
    std::erase_if(owners, [&](const std::string& name) { return !has(kind(name)); });
    throw InvalidInput::out_of_range(fmt::format("{}", option), fmt::format("--{} with --body {}", option, its.name),
                                     fmt::format("only with --body {}", fmt::join(owners, " or ")));
  };
  for (const auto& [name, value] : numbers_) {
    const std::string& of = name;
    require(name, value.has_value(), [&of](const Kind& each) { return parameter(each, of) != nullptr; });
  }
  require("plane", !plane_.empty(), [](const Kind& each) { return each.has_plane; });
  require("rigid-body", rigid_, [](const Kind& each) { return each.can_be_rigid; });
}

/// Whether there is something that only a body with a material has.
bool BodyOptions::in_si() const {
  return !material_.empty() || !plane_.empty() || c_p_ || c_s_ ||
         std::any_of(numbers_.begin(), numbers_.end(), [this](auto& of) {
           const Parameter* its = parameter(kind(kind_), of.first);
           return of.second && of.first != "poisson" && !is_of_whole(of.first) && (its == nullptr || !is_shape(*its));
         });
}

void BodyOptions::set_numbers(Participant& body) const {
  for (const auto& [name, value] : numbers_) {
    if (value) body.values[name] = *value;
  }
  if (c_p_) body.values["c_p"] = *c_p_;
  if (c_s_) body.values["c_s"] = *c_s_;
}

Participant BodyOptions::body() const {
  const Kind& its = kind(names_file(kind_) ? "modal" : kind_);
  require_own(its);
  if (its.from_file) {
    if (!material_.empty())
      throw InvalidInput::conflict("material", "the body file has one already", "leave out --material");
    Participant body = modal_from_file("body", kind_);
    if (!relaxation_.empty()) body.relaxation = parse_relaxation("relaxation", relaxation_);
    set_numbers(body);
    take_young(body, young_is_);
    return body;
  }
  Participant body{.kind = kind_, .material_name = material_, .rigid = rigid_};
  if (plane_ == "strain") body.plane = Plane::strain;
  set_numbers(body);
  if (has_poisson(body) && !body.values.contains("poisson") && material_.empty() && !c_p_ && !rigid_) {
    throw CLI::RequiredError("--poisson");
  }
  if (in_si()) set_material(body, 0.0, "material");
  if (!relaxation_.empty()) body.relaxation = parse_relaxation("relaxation", relaxation_);
  take_young(body, young_is_);
  return body;
}

}  // namespace stoss::cli
