#include "stoss/encounter/roughness.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "check.hpp"
#include "encounter/participant.hpp"

namespace stoss {
namespace {

constexpr Range at_least_zero{0.0, std::numeric_limits<double>::infinity(), true, false, "0 or more"};

/// Refuses one that is larger than the first body. @param size of that
void require_of_size(const Participant& of, double size) {
  for (const Parameter& each : kind(of.kind).parameters) {
    if (!is_of_face(each.name)) continue;
    const double most = each.high * (each.unit == "m" ? size : 1.0);
    require(each.name, given_or(of, each.name, each.default_value.value_or(0.0)),
            {each.low, most, true, true, shown(each.low) + " to " + shown_most(most)}, each.help);
  }
}

}  // namespace

double asperities_of(const Participant& of) {
  if (of.kind == "exponential")
    return 1.0 / given_or(of, "hardness", *parameter(kind(of.kind), "hardness")->default_value);
  const double roughness = given_or(of, "roughness", 0.0), u0 = given_or(of, "u0", 0.0);
  require("roughness", roughness, at_least_zero, "rms height of the asperities");
  require("u0", u0, at_least_zero, "length of the asperities");
  if (roughness > 0.0 && u0 > 0.0) {
    throw InvalidInput::conflict("roughness", "given beside u0, which is 0.45 of it", "give one of both");
  }
  return u0 > 0.0 ? u0 : asperities_over_rms * roughness;
}

double asperities_of(const Encounter& encounter) {
  const Participant& first = encounter.first;
  const Participant& against = encounter.against;
  const double size = size_of_first(encounter), its = asperities_of(first) / size;
  require_of_size(first, size);
  if (against.kind == "same") return std::hypot(its, its);
  const double other = with_prefix_against([&] {
    const double given = asperities_of(against);
    require_of_size(against, size);
    return given;
  });
  return std::hypot(its, against.kind == "exponential" ? other : other / size);
}

BodyMaker with_asperities(const BodyMaker& maker, double asperities) {
  require("u0", asperities, at_least_zero, "length of the asperities");
  if (asperities == 0.0) return maker;
  return [maker, asperities](double cutoff, const Poll& poll) {
    const Body body = maker(cutoff, poll);
    return rough(body, asperities / body.scale.length);
  };
}

void refuse_rough(const Encounter& encounter, const std::string& what) {
  const auto refuse = [&what](const Participant& of) {
    if (given_or(of, "yield_strength", 0.0) > 0.0) {
      throw InvalidInput::conflict("yield_strength", what + " knows elastic bodies alone", "leave it out");
    }
    if (given_or(of, "coat", 0.0) > 0.0)
      throw InvalidInput::conflict("coat", what + " knows bare faces alone", "leave it out");
    if (asperities_of(of) == 0.0) return;
    const char* name = of.kind == "exponential" ? "hardness" : given_or(of, "u0", 0.0) > 0.0 ? "u0" : "roughness";
    throw InvalidInput::conflict(name, what + " knows smooth faces alone", "leave it out");
  };
  refuse(encounter.first);
  with_prefix_against([&] { refuse(encounter.against); });
}

}  // namespace stoss
