#include "stoss/contact/contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "check.hpp"
#include "contact/contact_cache.hpp"
#include "contact/ellipse.hpp"
#include "contact/faces/coats.hpp"
#include "contact/unit_ratios.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Share of the first body in the approach: compressions go with softness.
double share_of_first(const Contact& contact, const UnitRatios& units) {
  const double first = contact.first->softness;
  return first / (first + contact.second->softness * units.softness);
}

/// Beyond the largest stable step of a body points of contact bounce on it; less so the more they are damped.
double stable_step(const Body& body) {
  constexpr double damping = 0.5;  // fit: 0.8 and more for ν up to 0.4999 of a sphere and 0.995 of a disk
  return body.stable_step + damping * body.loss_time;
}

/// The same of two bodies, R/c of the first. That of a sheet, whose thickness a wave crosses at once, may be far less
/// than the kept waves need. On 40 random sheets (h = 10⁻⁴ to 0.03, E = 0.01 to 1000, ρ = 0.001 to 100) under elastic
/// and rigid spheres, the longer step changed greatest force, time and compression by at most 3·10⁻⁴.
double stable_step(const Contact& contact, const UnitRatios& units) {
  constexpr double least = 1.0 / 128.0;  // times the cutoff
  const double own = std::min(stable_step(*contact.first), stable_step(*contact.second) * units.time);
  return std::max(own, least / contact.cutoff);
}

/// Adds a body's modes, in the units of the first body and with the modal mass of the contact.
void add_modes(const Body& body, const UnitRatios& units, std::size_t first_row, Contact& contact) {
  const double amplitude = std::sqrt(contact.mass / (body.mass * units.mass));
  for (const ModeGroup& from : body.groups) {
    ModeGroup group = from;
    group.upper_row += first_row;
    group.lower_row += first_row;
    group.wave_number /= units.length;
    for (double& omega : group.omega) omega /= units.time;
    for (double& weight : group.upper) weight *= amplitude;
    for (double& weight : group.lower) weight *= amplitude;
    contact.groups.push_back(std::move(group));
  }
}

/// Of the weaker one that yields; 0 if none does. @param units of the second
Strength weaker(const Strength& first, Strength second, const UnitRatios& units) {
  second.yield *= units.stress, second.reference /= units.time;
  return first.yield > 0.0 && (second.yield == 0.0 || first.yield <= second.yield) ? first : second;
}

/// The law of yield is one of bare and smooth faces.
void require_bare(const Contact& contact) {
  if (contact.yield.yield == 0.0) return;
  const bool coated = coat_compliance(contact) > 0.0;
  if (!coated && contact.asperities == 0.0) return;
  throw InvalidInput::conflict("yield_strength", coated ? "with a coat" : "with rough faces",
                               "a body that yields has bare and smooth faces here");
}

/// In this order it is m/2 to the last bit for equal bodies.
double reduced(double first, double second) { return std::isinf(second) ? first : first * (second / (first + second)); }

}  // namespace

Contact contact(std::shared_ptr<const Body> body, const Wall& wall) {
  validate(*body);
  validate(wall);
  if (is_unbounded(*body) || body->held) {
    throw InvalidInput::conflict("body", "'" + short_name(*body) + "' cannot meet a wall, because it does not move",
                                 "let another body meet it");
  }
  if (body->softness == 0.0) {
    throw InvalidInput::conflict("against", "a rigid body ('" + short_name(*body) +
                                                "') cannot meet a rigid wall; one of the two must be elastic");
  }
  if (body->contour == Contour::ball && body->curvature == 0.0) {
    throw InvalidInput::conflict(
        "curvature", "the surface of '" + body->name + "' is flat, as the wall is, and at least one must be curved");
  }
  body = as_round(std::move(body), 0.0);
  Contact contact;
  contact.wall = wall;
  contact.asperities = body->asperities;
  if (const auto* soft = std::get_if<ExponentialWall>(&wall)) {
    contact.asperities = std::hypot(contact.asperities, 1.0 / soft->hardness);
    contact.strength = soft->strength;
  }
  contact.mass = body->mass;
  contact.whole_mass = whole_mass(*body);
  contact.extent = body->extent;
  contact.cutoff = body->cutoff;
  contact.stable_step = stable_step(*body);
  contact.groups = body->groups;
  contact.first_groups = body->groups.size();
  contact.yield = body->strength;
  contact.first = std::move(body);
  require_bare(contact);
  contact.cache = std::make_shared<ContactCache>();
  return contact;
}

Contact contact(std::shared_ptr<const Body> first, std::shared_ptr<const Body> second) {
  validate(*first);
  validate(*second);
  require_partners(*first, *second);
  const UnitRatios units(*second, *first);
  const double own = first->curvature, met = second->curvature;
  first = as_round(std::move(first), met / units.length);
  second = as_round(std::move(second), own * units.length);
  Contact contact;
  contact.mass = reduced(first->mass, is_unbounded(*second) ? whole_mass(*second) : second->mass * units.mass);
  contact.whole_mass = reduced(whole_mass(*first), whole_mass(*second) * units.mass);
  contact.extent = first->extent + second->extent * units.length;
  contact.asperities = std::hypot(first->asperities, second->asperities * units.length);
  contact.cutoff = std::max(first->cutoff, second->cutoff / units.time);
  contact.radius = is_unbounded(*second) ? 1.0 : std::min(1.0, units.length);
  add_modes(*first, UnitRatios{}, 0, contact);
  contact.first_groups = contact.groups.size();
  contact.unbounded = is_unbounded(*second);
  contact.keeps_displacement = second->part.keeps_displacement;
  add_modes(*second, units, shape_rows(*first), contact);
  contact.yield = weaker(first->strength, second->strength, units);
  contact.first = std::move(first);
  contact.second = std::move(second);
  require_bare(contact);
  contact.stable_step = stable_step(contact, units);
  contact.cache = std::make_shared<ContactCache>();
  return contact;
}

Contact contact(Body body, const Wall& wall) { return contact(std::make_shared<const Body>(std::move(body)), wall); }

Contact contact(Body first, Body second) {
  return contact(std::make_shared<const Body>(std::move(first)), std::make_shared<const Body>(std::move(second)));
}

std::string name(const Contact& contact) {
  return contact.second == nullptr ? contact.first->name : contact.first->name + " at " + contact.second->name;
}

bool has_single_point(const Contact& contact) { return contact.first->contour == Contour::flat; }

double mach_number(const Contact& contact, double speed) {
  if (contact.second == nullptr) return speed;
  const UnitRatios units = units_of(contact, 1);
  const double share = share_of_first(contact, units);
  return speed * std::max(share, (1.0 - share) * units.time / units.length);
}

double own_compression(const Contact& contact, double approach) {
  if (contact.second == nullptr) return approach;
  const UnitRatios units = units_of(contact, 1);
  const double share = share_of_first(contact, units);
  return approach * std::max(share, (1.0 - share) / (is_unbounded(*contact.second) ? 1.0 : units.length));
}

double longest_time(const Contact& contact) {
  if (contact.second == nullptr) return contact.first->part.size;
  const double second = contact.second->part.size * units_of(contact, 1).time;
  return is_unbounded(*contact.second) ? time_scale(contact) : std::max(contact.first->part.size, second);
}

std::shared_ptr<const Body> body_of(const Contact& contact, int number) {
  if (number == 0) return contact.first;
  return number == 1 ? contact.second : nullptr;
}

std::size_t lasting_groups(const Contact& contact) {
  return contact.unbounded ? contact.first_groups : contact.groups.size();
}

std::size_t mode_count(const Contact& contact) {
  return mode_count(*contact.first) + (contact.second == nullptr ? 0 : mode_count(*contact.second));
}

double modal_mass(const Contact& contact, std::size_t group) {
  if (contact.second == nullptr) return contact.mass;
  if (group < contact.first_groups) return contact.first->mass;
  return contact.second->mass * units_of(contact, 1).mass;
}

double loss_time(const Contact& contact, std::size_t group) {
  if (group < contact.first_groups) return contact.first->loss_time;
  return contact.second->loss_time * units_of(contact, 1).time;
}

Relaxation relaxation(const Contact& contact, std::size_t group) {
  if (group < contact.first_groups) return contact.first->relaxation;
  return in_time(contact.second->relaxation, units_of(contact, 1).time);
}

bool loses(const Contact& contact) {
  const auto its = [](const Body& body) { return loses(body) || !body.coat.relaxation.terms.empty(); };
  return its(*contact.first) || (contact.second != nullptr && its(*contact.second));
}

double longest_loss_time(const Contact& contact) {
  const double first = longest_loss_time(*contact.first);
  if (contact.second == nullptr) return first;
  return std::max(first, longest_loss_time(*contact.second) * units_of(contact, 1).time);
}

double highest_wave_number(const Contact& contact) {
  double highest = 0.0;
  for (const ModeGroup& group : contact.groups) highest = std::max(highest, group.wave_number);
  return highest;
}

double time_scale(const Contact& contact) {
  if (contact.second == nullptr) return 1.0;
  const UnitRatios units = units_of(contact, 1);
  // Waves in flat-ended bodies run to and fro without spreading: the shorter body sets what has to be resolved.
  if (has_single_point(contact)) return std::min(1.0, units.time);
  const double first_softness = contact.first->softness > 0.0 ? 1.0 / whole_mass(*contact.first) : 0.0;
  const double second_mass = whole_mass(*contact.second) * units.mass;
  double second_softness = units.time * units.time / second_mass;
  // As a body of the size of the first.
  if (is_unbounded(*contact.second)) second_softness = units.softness / whole_mass(*contact.first);
  if (contact.second->softness == 0.0) second_softness = 0.0;
  return std::sqrt(contact.whole_mass * (first_softness + second_softness));
}

double echo_time(const Contact& contact) {
  if (contact.second == nullptr) return contact.first->part.echo;
  return std::min(contact.first->part.echo, contact.second->part.echo * units_of(contact, 1).time);
}

double unresolved_share(const Contact& contact) {
  if (contact.second == nullptr) return 1.0;
  // On a short arc around the foremost point, the same for both.
  constexpr double short_arc = 1e-3;
  ContactPoints axis{contact.radius, has_single_point(contact) ? 0.0 : short_arc, 1};
  const double first = contact.first->surface(axis).impedance.front();
  const UnitRatios units = units_of(contact, 1);
  axis.radius /= units.length;
  const double second = contact.second->surface(axis).impedance.front() * units.impedance;
  return second / (first + second);
}

}  // namespace stoss
