// The options that say who meets whom.
#include "input/encounter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app.hpp"
#include "input/inputs.hpp"
#include "process/process.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

/// The keys of a kind as --against has them.
std::vector<std::string> keys_of(const Kind& its) {
  std::vector<std::string> keys;
  for (const Parameter& each : its.parameters) keys.emplace_back(each.name);
  if (its.can_be_rigid) keys.emplace_back("rigid");
  if (!its.wall) keys.insert(keys.end(), {"relaxation", "young_is"});
  if (!its.wall && !its.from_file) keys.emplace_back("material");
  if (parameter(its, "poisson") != nullptr) keys.insert(keys.end(), {"c_p", "c_s"});
  return keys;
}

/// What stands for it.
std::string_view name_of(const Kind& its) { return its.from_file ? "@FILE" : its.name; }

/// Its help: name, keys, and what it is.
std::string lines_of(const Kind& its) {
  const std::vector<std::string> keys = keys_of(its);
  std::string with = keys.empty() ? "" : fmt::format(",\n   keys {}", fmt::join(keys, ", "));
  if (its.add_layer) with += "\n   and layers below, as /KEY=NUMBER,... (the last may be a block)";
  return fmt::format("\n  {}: {}{}", name_of(its), its.help, with);
}

/// The keys of a further layer of one.
std::vector<std::string> layer_keys_of(const Kind& its) {
  std::vector<std::string> keys;
  for (const Parameter& each : its.parameters) {
    if (!is_of_whole(each.name)) keys.emplace_back(each.name);
  }
  keys.insert(keys.end(), {"material", "c_p", "c_s"});
  return keys;
}

/// What the parts key=value from one on say of a kind, or of one of its layers.
/// @param first of which the Poisson's ratio is that of a material without its own
/// @param young_is what is said of the modulus, which is for all layers
Participant parse_numbers(const Kind& its, const std::vector<std::string>& parts, std::size_t from,
                          const std::vector<std::string>& keys, const Participant& first, std::string& young_is) {
  Participant against{.kind = std::string(its.name), .plane = first.plane};
  std::string relaxation;
  for (const auto& [key, value] : parse_keys("against", parts, from, keys, fmt::format(" with {}", name_of(its)))) {
    if (key == "material") {
      against.material_name = without_spaces(value);
    } else if (key == "relaxation") {
      relaxation = without_spaces(value);
    } else if (key == "young_is") {
      young_is = without_spaces(value);
      const std::vector<std::string> words{"instantaneous", "relaxed"};
      if (std::find(words.begin(), words.end(), young_is) == words.end()) {
        refuse_word("against young_is", young_is, words);
      }
    } else if (const double number = parse_number("against " + key, value); key == "rigid") {
      if (number != 0.0 && number != 1.0) {
        throw InvalidInput::out_of_range("against rigid", shortened(value), "0 or 1", "1 of a rigid body");
      }
      against.rigid = number == 1.0;
    } else {
      against.values[key] = number;
    }
  }
  const bool in_si = first.material || !against.material_name.empty();
  if (in_si && !its.wall && !its.from_file && meets(kind(first.kind), its)) {
    set_material(against, first.material ? first.material->poisson : 0.0, "against");
  }
  if (!relaxation.empty()) against.relaxation = parse_relaxation("against relaxation", relaxation);
  return against;
}

/// With its modulus as "instantaneous" or "relaxed".
Participant with_young(Participant against, const std::string& young_is) {
  try {
    take_young(against, young_is);
  } catch (const InvalidInput& error) {
    throw error.within("against");
  }
  return against;
}

/// @FILE[,key=value…]: the name of the file, which may have commas, ends where a key and its value follow one.
Participant parse_file(const std::string& text, const Participant& first) {
  const std::vector<std::string> parts = split(text, ',');
  std::size_t keys = 1;
  while (keys < parts.size() && parts[keys].find('=') == std::string::npos) ++keys;
  const Kind& its = kind("modal");
  std::string young_is;
  Participant given = parse_numbers(its, parts, keys, keys_of(its), first, young_is);
  Participant of_file = modal_from_file(
      "against", fmt::format("{}", fmt::join(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(keys), ",")));
  of_file.values = std::move(given.values), of_file.relaxation = std::move(given.relaxation);
  return with_young(std::move(of_file), young_is);
}

/// What --against says: KIND[,key=value…], with the numbers of further layers after slashes.
/// @throws InvalidInput for an unknown kind or key, a key that comes twice, and what is no number
Participant parse_against(const std::string& text, const Participant& first) {
  if (names_file(text)) return parse_file(text, first);
  const std::vector<std::string> layers = split(text, '/');
  const std::vector<std::string> parts = split(layers.front(), ',');
  std::vector<std::string> names;
  for (const Kind& each : kinds()) {
    if (!each.from_file) names.emplace_back(each.name);
  }
  const std::string name = without_spaces(parts.front());
  if (std::find(names.begin(), names.end(), name) == names.end()) refuse_word("against", name, names);
  const Kind& its = kind(name);
  std::string young_is;
  Participant against = parse_numbers(its, parts, 1, keys_of(its), first, young_is);
  for (std::size_t i = 1; i < layers.size(); ++i) {
    against.below.push_back(parse_numbers(its, split(layers[i], ','), 0, layer_keys_of(its), first, young_is));
  }
  return with_young(std::move(against), young_is);
}

}  // namespace

void EncounterOptions::add_to(CLI::App& to, const std::string& note) {
  first.add_kind_to(to, {"sphere", "hollow-sphere", "disk", "rod"}, true);
  first.add_dynamics_to(to);
  first.add_material_to(to);
  std::string help =
      "What the body meets (default: wall); numbers in units of the first, or\nin SI if it has a material";
  std::vector<std::string_view> names;
  for (const Kind& its : kinds()) {
    help += lines_of(its);
    if (!its.from_file) names.push_back(its.name);
  }
  const std::string type = fmt::format("{{{}}}[,KEY=VALUE]...", fmt::join(names, ","));
  add(to, "--against", against, help + note, type, "Against");
}

Encounter EncounterOptions::encounter() const {
  Encounter encounter{.first = first.body()};
  encounter.against = parse_against(against, encounter.first);
  encounter.vibration = vibration_of(modes);
  validate(encounter);
  return encounter;
}

void KeptOptions::add_to(CLI::App& command, Question question) {
  add_choice(command, "--tail", word, {"radiating", "static", "none"},
             "Model of the modes above the cutoff: radiating absorbs energy, static does not; none, of rough faces\n"
             "alone: as in the paper, they do not answer (default: radiating)",
             "TAIL", "Resolution");
  add_input(command, question, "cutoff", cutoff, "Resolution");
}

Tail KeptOptions::tail() const {
  if (word == "none") return Tail::none;
  return word == "static" ? Tail::quasistatic : Tail::radiating;
}

void KeptOptions::choose(const CLI::App& command, const Encounter& encounter, double slowest, double most,
                         const Poll& poll) {
  if (!given(command, "--cutoff")) cutoff = usual_cutoff(encounter, slowest, most, poll);
}

Provenance KeptOptions::provenance(const CLI::App& command, const Encounter& encounter) const {
  Provenance its = cli::provenance(command, encounter);
  its.inputs["cutoff"] = cutoff;
  its.inputs["tail"] = word;
  return its;
}

std::optional<double> poisson_of(const Encounter& encounter) {
  return std::visit(
      [](const auto& of) -> std::optional<double> {
        if constexpr (requires { of.poisson; }) return of.poisson;
        return std::nullopt;
      },
      first_solid(encounter));
}

}  // namespace stoss::cli
