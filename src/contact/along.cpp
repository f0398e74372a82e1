#include "contact/along.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "contact/unit_ratios.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

std::vector<Body> bodies_along(const Body& body, const Poll& poll) {
  if (body.along) return body.along(poll);
  throw InvalidInput::conflict("friction",
                               "not available for '" + short_name(body) +
                                   "', but for disks, spheres, half-spaces, plates, and modal bodies with a tangent",
                               "leave friction out, or take 0");
}

double own_mass_along(const Body& body) { return body.mass_along > 0.0 ? body.mass_along : whole_mass(body); }

/// (c_s/c_p)² of a body that mixes directions, from the impedances of its foremost point.
double mixing_of(const Body& body, double radius) {
  if (body.softness == 0.0) return 0.0;
  constexpr double short_arc = 1e-9;
  const std::vector<double> impedance = body.surface({radius, short_arc, 1}).impedance;
  return impedance[1] * impedance[1] / (impedance[0] * impedance[0]);
}

}  // namespace

double mass_along(const Contact& contact) {
  const double first = own_mass_along(*contact.first);
  if (contact.second == nullptr) return first;
  if (contact.first->mass_along == 0.0 && contact.second->mass_along == 0.0) return contact.whole_mass;
  if (is_unbounded(*contact.second)) return first;
  const double second = own_mass_along(*contact.second) * units_of(contact, 1).mass;
  return first * (second / (first + second));
}

double share_along(const Contact& contact, int number) {
  const Body& body = number == 0 ? *contact.first : *contact.second;
  return mass_along(contact) / (own_mass_along(body) * units_of(contact, number).mass);
}

double mixing(const std::vector<Contact>& along) {
  const Contact& contact = along.front();
  if (contact.first->components == 1) return 0.0;
  const double first = contact.first->softness, one = first * mixing_of(*contact.first, contact.radius);
  if (contact.second == nullptr) return one / first;
  const UnitRatios units = units_of(contact, 1);
  const double second = contact.second->softness * units.softness;
  const double other = second * mixing_of(*contact.second, contact.radius / units.length);
  return std::abs(one - other) / (first + second);
}

double stable_friction(const std::vector<Contact>& along) {
  constexpr double rounding = 1e-12;
  const double beta = mixing(along);
  return beta > rounding ? 0.5 / std::sqrt(beta * (1.0 - beta)) : std::numeric_limits<double>::infinity();
}

Contact contact_outward(const Contact& contact, const Poll& poll) {
  const auto outward = [&poll](const Body& body) {
    if (body.outward) return body.outward(poll);
    throw InvalidInput::out_of_range("friction", "'" + body.name + "'", "only balls: spheres and half-spaces");
  };
  if (contact.second == nullptr) return stoss::contact(outward(*contact.first));
  return stoss::contact(outward(*contact.first), outward(*contact.second));
}

std::vector<Contact> contacts_along(const Contact& contact, const Poll& poll) {
  std::vector<Contact> along;
  std::vector<Body> first = bodies_along(*contact.first, poll);
  if (contact.second == nullptr) {
    for (Body& each : first) along.push_back(stoss::contact(std::move(each)));
    return along;
  }
  std::vector<Body> second = bodies_along(*contact.second, poll);
  for (std::size_t k = 0; k < first.size() && k < second.size(); ++k) {
    along.push_back(stoss::contact(std::move(first[k]), std::move(second[k])));
  }
  return along;
}

}  // namespace stoss
