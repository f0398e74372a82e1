// What belongs to a body beside its modes: how its material relaxes and yields, how rough it is.
#include "body/changed.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using Change = std::function<Body(const Body&)>;

/// A function that makes one body or several, which are then changed.
template <typename... Given>
void change_results(std::function<Body(Given...)>& make, const Change& change) {
  if (make) make = [make, change](Given... given) { return change(make(given...)); };
}

template <typename... Given>
void change_results(std::function<std::vector<Body>(Given...)>& make, const Change& change) {
  if (!make) return;
  make = [make, change](Given... given) {
    std::vector<Body> bodies;
    for (const Body& each : make(given...)) bodies.push_back(change(each));
    return bodies;
  };
}

double unit_of_time(const BodyScale& scale) { return scale.length / scale.speed; }

void require_asperities(double asperities) {
  stoss::require("asperities", asperities, {0.0, 1e3, true, true, "0 to 1000"}, "length of the asperities in R");
}

void require_mass(double mass) {
  stoss::require("extra_mass", mass, {0.0, 1e100, true, true, "0 or more"}, "a mass fixed to the body");
}

void require_strength(const Strength& strength) {
  constexpr double most_hardening = 0.03;  // of the finite elements (stoss/contact/elastic_plastic.hpp)
  const Range share{0.0, 1.0, true, true, "0 to 1"};
  stoss::require("yield_strength", strength.yield, share, "yield strength in E");
  stoss::require("yield_hardening", strength.hardening, {0.0, most_hardening, true, true, "0 to 0.03"},
                 "growth of the strength with plastic strain, in E");
  stoss::require("yield_rate", strength.rate, share, "C of Y (1 + C ln(rate of strain / reference))");
  stoss::require("yield_reference", strength.reference, {0.0, 1e100, false, true, "above 0"}, "rate of strain in c/R");
}

}  // namespace

double unit_of_coats(const Body& body) {
  const BodyScale& its = body.scale;
  const double area = body.contour == Contour::ball ? its.length * its.length : its.length;
  return area * its.length * its.length * body.mass / (its.mass * its.speed * its.speed);
}

Body changed(Body body, const Change& change) {
  change_results(body.near_side, change);
  change_results(body.along, change);
  change_results(body.outward, change);
  change_results(body.known.alternatives, change);
  change_results(body.known.alternatives_along, change);
  return body;
}

Body relaxing(const Body& body, const Relaxation& relaxation) {
  validate(relaxation);
  if (relaxation.terms.empty()) return body;
  if (body.loss_time > 0.0) {
    throw InvalidInput::conflict("relaxation", "'" + body.name + "' has a loss time too", "give one of both");
  }
  if (!body.layers.empty()) {
    throw InvalidInput::conflict("relaxation", "the layers of '" + body.name + "' have losses of their own",
                                 "give one of both");
  }
  if (body.softness == 0.0) {
    throw InvalidInput::conflict("relaxation", "'" + body.name + "' is rigid, and relaxes nothing", "leave it out");
  }
  Body result = changed(body, [relaxation, scale = body.scale](const Body& each) {
    return relaxing(each, in_time(relaxation, unit_of_time(scale) / unit_of_time(each.scale)));
  });
  result.relaxation = relaxation;
  return result;
}

BodyMaker relaxing(const BodyMaker& maker, const Relaxation& relaxation) {
  validate(relaxation);
  if (relaxation.terms.empty()) return maker;
  return [maker, relaxation](double cutoff, const Poll& poll) { return relaxing(maker(cutoff, poll), relaxation); };
}

Body rough(const Body& body, double asperities) {
  require_asperities(asperities);
  if (asperities == 0.0) return body;
  Body result = changed(body, [asperities, scale = body.scale](const Body& each) {
    return rough(each, asperities * scale.length / each.scale.length);
  });
  result.asperities = asperities;
  result.name += " asperities=" + shown(asperities);
  return result;
}

BodyMaker rough(const BodyMaker& maker, double asperities) {
  require_asperities(asperities);
  if (asperities == 0.0) return maker;
  return [maker, asperities](double cutoff, const Poll& poll) { return rough(maker(cutoff, poll), asperities); };
}

Body yielding(const Body& body, const Strength& strength) {
  require_strength(strength);
  if (strength.yield == 0.0) return body;
  if (body.softness == 0.0) {
    throw InvalidInput::conflict("yield_strength", "'" + body.name + "' is rigid, and does not yield", "leave it out");
  }
  if (body.contour != Contour::ball) {
    throw InvalidInput::conflict("yield_strength", "'" + body.name + "' does not touch on a circle",
                                 "the model of yield is one of balls");
  }
  Body result = changed(body, [strength, own = unit_of_time(body.scale)](const Body& each) {
    return yielding(
        each, {strength.yield, strength.hardening, strength.rate, strength.reference * unit_of_time(each.scale) / own});
  });
  result.strength = strength;
  result.name += " yield_strength=" + shown(strength.yield);
  return result;
}

BodyMaker yielding(const BodyMaker& maker, const Strength& strength) {
  require_strength(strength);
  if (strength.yield == 0.0) return maker;
  return [maker, strength](double cutoff, const Poll& poll) { return yielding(maker(cutoff, poll), strength); };
}

Body laden(const Body& body, double mass) {
  require_mass(mass);
  if (mass == 0.0) return body;
  if (body.contour != Contour::ball || !is_whole(body) || is_known_at_a_point(body)) {
    throw InvalidInput::conflict("extra_mass", "'" + body.name + "' is no ball", "leave it out");
  }
  Body result = body;
  const double heavier = 1.0 + mass / body.scale.mass;
  result.name += " extra_mass=" + shown(mass);
  result.scale.mass *= heavier, result.mass *= heavier;
  for (ModeGroup& group : result.groups) {  // modal mass is that of the body
    for (double& weight : group.upper) weight *= std::sqrt(heavier);
    for (double& weight : group.lower) weight *= std::sqrt(heavier);
  }
  result.inertia = 0.0, result.outward = nullptr;
  result.along = [](const Poll&) -> std::vector<Body> {
    throw InvalidInput::conflict("extra_mass", "friction turns a body, and how this mass turns is not known",
                                 "compute without friction");
  };
  return result;
}

BodyMaker laden(const BodyMaker& maker, double mass) {
  require_mass(mass);
  if (mass == 0.0) return maker;
  return [maker, mass](double cutoff, const Poll& poll) { return laden(maker(cutoff, poll), mass); };
}

void validate(const Coat& coat) {
  const Range range{0.0, 1e12, true, true, "0 to 1e12"};
  require("coat", coat.compliance, range, "thickness over modulus in R/E");
  require("coat along", coat.along, range, "thickness over shear modulus in R/E");
  validate(coat.relaxation);
}

Body coated(const Body& body, const Coat& coat) {
  validate(coat);
  if (coat.compliance == 0.0) return body;
  const double own_compliance = unit_of_coats(body), own_time = unit_of_time(body.scale);
  Body result = changed(body, [coat, own_compliance, own_time](const Body& each) {
    const double ratio = own_compliance / unit_of_coats(each), time = own_time / unit_of_time(each.scale);
    return coated(each, {coat.compliance * ratio, coat.along * ratio, in_time(coat.relaxation, time)});
  });
  if (result.along) {
    result.along = [along = result.along](const Poll& poll) {
      std::vector<Body> bodies = along(poll);
      for (Body& each : bodies) {
        if (each.components == 1) each.coat.compliance = each.coat.along;  // it moves along its face alone
      }
      return bodies;
    };
  }
  result.coat = coat;
  result.name += " coat=" + shown(coat.compliance);
  return result;
}

BodyMaker coated(const BodyMaker& maker, const Coat& coat) {
  validate(coat);
  if (coat.compliance == 0.0) return maker;
  return [maker, coat](double cutoff, const Poll& poll) { return coated(maker(cutoff, poll), coat); };
}

}  // namespace stoss
