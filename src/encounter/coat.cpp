// What covers the face of a body, as it is given.
#include "encounter/coat.hpp"

#include <array>
#include <numbers>
#include <string>

#include "body/changed.hpp"
#include "check.hpp"
#include "encounter/participant.hpp"
#include "stoss/errors.hpp"
#include "stoss/relaxation/constant_quality.hpp"

namespace stoss {
namespace {

/// Unit of lengths and of moduli in which sizes and moduli are given: of a first body with R = E = 1 its own.
std::array<double, 2> units_of(const Encounter& encounter) {
  const auto its = si_scales(encounter);
  if (!its || encounter.first.kind == "rod") return {1.0, 1.0};
  const bool line = kind(encounter.first.kind).contour == Contour::cylinder;
  const double of_sphere = 4.0 / 3.0 * its->length;
  return {its->length, its->force / (std::numbers::pi * its->length * (line ? 1.0 : of_sphere))};
}

}  // namespace

Coat coat_of(const Encounter& encounter, const Participant& of) {
  const double thickness = given_or(of, "coat", 0.0), young = given_or(of, "coat_young", 0.0);
  const double poisson = given_or(of, "coat_poisson", 0.3), quality = given_or(of, "coat_quality", 0.0);
  if (thickness == 0.0) {
    if (young > 0.0 || quality > 0.0) {
      const char* other = young > 0.0 ? "coat_young" : "coat_quality";
      throw InvalidInput::missing("coat", "", std::string("its thickness; there is a ") + other);
    }
    return {};
  }
  if (young == 0.0) throw InvalidInput::missing("coat_young", "", "a coat needs its modulus");
  const auto [length, modulus] = units_of(encounter);
  const double confined = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  const double shear = 0.5 * young / (1.0 + poisson), size = thickness / length;
  Coat made{size * modulus / confined, size * modulus / shear, {}};
  if (quality > 0.0) {
    require("coat_quality", quality, {3.0, 1e9, true, true, "3 to 1e9"}, "the same at all frequencies; 0: no loss");
    made.relaxation = constant_quality(quality, lowest_of_body, highest_of_body);
  }
  return made;
}

BodyMaker coated_in_units_of_first(const BodyMaker& bare, const Coat& coat) {
  if (coat.compliance == 0.0) return bare;
  return [bare, coat](double cutoff, const Poll& poll) {
    const Body body = bare(cutoff, poll);
    const double unit = unit_of_coats(body), time = body.scale.length / body.scale.speed;
    return coated(body, {coat.compliance / unit, coat.along / unit, in_time(coat.relaxation, 1.0 / time)});
  };
}

}  // namespace stoss
