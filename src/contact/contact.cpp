#include "stoss/contact/contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "check.hpp"
#include "contact/units.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Share of the first body in the approach: compressions go with softness.
double share_of_first(const Contact& contact, const Units& units) {
  const double first = contact.first->softness;
  return first / (first + contact.second->softness * units.softness);
}

/// Adds a body's modes, in the units of the first body and with the modal mass of the contact.
void add_modes(const Body& body, const Units& units, std::size_t first_row, Contact& contact) {
  const double amplitude = std::sqrt(contact.mass / (body.mass * units.mass));
  for (const ModeGroup& from : body.groups) {
    ModeGroup group = from;
    group.upper_row += first_row;
    group.lower_row += first_row;
    for (double& omega : group.omega) omega /= units.time;
    for (double& weight : group.upper) weight *= amplitude;
    for (double& weight : group.lower) weight *= amplitude;
    contact.groups.push_back(std::move(group));
  }
}

/// In this order it is m/2 to the last bit for equal bodies.
double reduced(double first, double second) { return first * (second / (first + second)); }

}  // namespace

std::size_t shape_rows(const Body& body) {
  std::size_t rows = 0;
  for (const ModeGroup& group : body.groups) rows = std::max({rows, group.upper_row + 1, group.lower_row + 1});
  return rows;
}

Contact contact(std::shared_ptr<const Body> body, const Wall& wall) {
  validate(*body);
  validate(wall);
  Contact contact;
  contact.wall = wall;
  contact.mass = body->mass;
  contact.whole_mass = whole_mass(*body);
  contact.extent = body->extent;
  contact.cutoff = body->cutoff;
  contact.stable_step = body->stable_step;
  contact.groups = body->groups;
  contact.first_groups = body->groups.size();
  contact.first = std::move(body);
  return contact;
}

Contact contact(std::shared_ptr<const Body> first, std::shared_ptr<const Body> second) {
  validate(*first);
  validate(*second);
  require_partners(*first, *second);
  const Units units(*second, *first);
  Contact contact;
  contact.mass = reduced(first->mass, second->mass * units.mass);
  contact.whole_mass = reduced(whole_mass(*first), whole_mass(*second) * units.mass);
  contact.extent = first->extent + second->extent * units.length;
  contact.cutoff = std::max(first->cutoff, second->cutoff / units.time);
  contact.stable_step = std::min(first->stable_step, second->stable_step * units.time);
  contact.radius = std::min(1.0, units.length);
  add_modes(*first, Units{}, 0, contact);
  contact.first_groups = contact.groups.size();
  add_modes(*second, units, shape_rows(*first), contact);
  contact.first = std::move(first);
  contact.second = std::move(second);
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

double own_speed(const Contact& contact, double speed) {
  if (contact.second == nullptr) return speed;
  const Units units(*contact.second, *contact.first);
  const double share = share_of_first(contact, units);
  return speed * std::max(share, (1.0 - share) * units.time / units.length);
}

double own_compression(const Contact& contact, double approach) {
  if (contact.second == nullptr) return approach;
  const Units units(*contact.second, *contact.first);
  const double share = share_of_first(contact, units);
  return approach * std::max(share, (1.0 - share) / units.length);
}

double longest_time(const Contact& contact) {
  if (contact.second == nullptr) return contact.first->part.size;
  return std::max(contact.first->part.size, contact.second->part.size * Units(*contact.second, *contact.first).time);
}

std::size_t mode_count(const Contact& contact) {
  return mode_count(*contact.first) + (contact.second == nullptr ? 0 : mode_count(*contact.second));
}

double modal_mass(const Contact& contact, std::size_t group) {
  if (contact.second == nullptr) return contact.mass;
  if (group < contact.first_groups) return contact.first->mass;
  return contact.second->mass * Units(*contact.second, *contact.first).mass;
}

double loss_time(const Contact& contact, std::size_t group) {
  if (group < contact.first_groups) return contact.first->loss_time;
  return contact.second->loss_time * Units(*contact.second, *contact.first).time;
}

double longest_loss_time(const Contact& contact) {
  const double first = contact.first->loss_time;
  if (contact.second == nullptr) return first;
  return std::max(first, contact.second->loss_time * Units(*contact.second, *contact.first).time);
}

double highest_wave_number(const Contact& contact) {
  const double first = contact.first->part.size;
  const double second =
      contact.second == nullptr ? 1.0 : Units(*contact.second, *contact.first).length * contact.second->part.size;
  double highest = 0.0;
  for (std::size_t g = 0; g < contact.groups.size(); ++g) {
    highest = std::max(highest, contact.groups[g].order / (g < contact.first_groups ? first : second));
  }
  return highest;
}

double time_scale(const Contact& contact) {
  if (contact.second == nullptr) return 1.0;
  const Units units(*contact.second, *contact.first);
  // Waves in flat-ended bodies run to and fro without spreading: the shorter body sets what has to be resolved.
  if (has_single_point(contact)) return std::min(1.0, units.time);
  const double first_stiffness = whole_mass(*contact.first);
  const double second_stiffness = whole_mass(*contact.second) * units.mass / (units.time * units.time);
  return std::sqrt(contact.whole_mass * (1.0 / first_stiffness + 1.0 / second_stiffness));
}

double unresolved_share(const Contact& contact) {
  if (contact.second == nullptr) return 1.0;
  // On a short arc around the foremost point, the same for both.
  constexpr double short_arc = 1e-3;
  ContactPoints axis{contact.radius, has_single_point(contact) ? 0.0 : short_arc, 1};
  const double first = contact.first->surface(axis).impedance.front();
  const Units units(*contact.second, *contact.first);
  axis.radius /= units.length;
  const double second = contact.second->surface(axis).impedance.front() * units.impedance;
  return second / (first + second);
}

}  // namespace stoss
