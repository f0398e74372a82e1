#include "contact/along.hpp"

#include <utility>
#include <variant>

#include "stoss/errors.hpp"

namespace stoss {
namespace {

std::vector<Body> bodies_along(const Body& body, const Poll& poll) {
  if (body.along) return body.along(poll);
  throw InvalidInput("friction: got '" + body.name +
                     "', allowed only bodies whose surface can move along another: disks, spheres, half-spaces (leave "
                     "friction out, or take 0)");
}

}  // namespace

std::vector<Contact> contacts_along(const Contact& contact, const Poll& poll) {
  if (!std::holds_alternative<HardWall>(contact.wall)) {
    throw InvalidInput("friction: got an exponential wall, allowed only a rigid one (it has no law along it)");
  }
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
