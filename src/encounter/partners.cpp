#include "encounter/partners.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "encounter/participant.hpp"
#include "stoss/encounter/kinds.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Names after each other, with a word before the last: "a, b or c".
std::string joined(const std::vector<std::string>& names, const std::string& last) {
  std::string text = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) text += (i + 1 == names.size() ? last : ", ") + names[i];
  return text;
}

/// "sphere or half-space": what a body meets besides walls and its like.
/// @param names that are said before these
std::string partners_of(const Kind& first, std::vector<std::string> names = {}) {
  for (const Kind& each : kinds()) {
    if (!each.wall && meets(first, each)) names.emplace_back(each.name);
  }
  return joined(names, " or ");
}

void require_partner(const Encounter& encounter) {
  const Kind& first = kind(encounter.first.kind);
  if (!first.bounded) {
    throw InvalidInput::conflict("body",
                                 "a " + std::string(first.name) + " cannot be the first body, because it does not move",
                                 "give it as what is met");
  }
  const Kind& against = kind(encounter.against.kind);
  if (meets(first, against)) return;
  throw InvalidInput::out_of_range("against", std::string(against.name) + " for a " + std::string(first.name),
                                   partners_of(first, {"wall", "same"}), who_meets_whom());
}

void require_rigid(const Participant& of) {
  if (!of.rigid) return;
  if (!kind(of.kind).can_be_rigid) {
    throw InvalidInput::out_of_range("rigid", "a rigid " + of.kind, "a disk or a sphere");
  }
  (void)losses_of(of);
}

void require_one_that_deforms(const Encounter& encounter) {
  require_rigid(encounter.first);
  with_prefix_against([&] { require_rigid(encounter.against); });
  const bool other = kind(encounter.against.kind).wall || encounter.against.rigid;
  if (encounter.first.rigid && other) {
    throw InvalidInput::out_of_range(
        "rigid", "a rigid " + encounter.first.kind + " against " + encounter.against.kind,
        "only against an elastic " + partners_of(kind(encounter.first.kind)) + ", which deforms");
  }
}

bool takes_material(const Kind& kind) {
  return kind.from_file || std::any_of(kind.parameters.begin(), kind.parameters.end(),
                                       [](const Parameter& each) { return each.of_material; });
}

void require_units(const Encounter& encounter) {
  const Kind& against = kind(encounter.against.kind);
  const bool material = encounter.against.material.has_value();
  if (!takes_material(against)) {
    if (material)
      throw InvalidInput::conflict("against", "a " + std::string(against.name) + " has no material", "leave it out");
    return;
  }
  if (encounter.first.material.has_value() == material) return;
  if (material) {
    throw InvalidInput::conflict("against", "has a material, but the first body is dimensionless",
                                 "give both a material and sizes in SI, or ratios");
  }
  throw InvalidInput::conflict("against", "needs a material too, because the first body has one",
                               "e.g. " + std::string(against.name) + ",material=glass");
}

}  // namespace

std::string who_meets_whom() {
  std::string text;
  for (const Contour contour : {Contour::cylinder, Contour::ball, Contour::flat}) {
    std::vector<std::string> firsts, others;
    for (const Kind& each : kinds()) {
      if (each.wall || each.contour != contour) continue;
      if (each.bounded) firsts.push_back(std::string(each.name) + (each.from_file ? " body" : ""));
      others.emplace_back(each.plural);
    }
    text += (text.empty() ? "a " : "; a ") + joined(firsts, " or ") + (text.empty() ? " meets " : " ") +
            joined(others, " and ");
  }
  return text;
}

void require_partners(const Encounter& encounter) {
  require_partner(encounter);
  require_one_that_deforms(encounter);
  require_units(encounter);
}

}  // namespace stoss
