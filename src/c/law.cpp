#include "c/law.hpp"

#include <variant>

#include "stoss/errors.hpp"
#include "stoss/table/slow_law.hpp"

namespace stoss::c {
namespace {

[[noreturn]] SlowLaw no_law() {
  throw InvalidInput(
      "beyond: got STOSS_BEYOND_LAW, allowed STOSS_BEYOND_ERROR or STOSS_BEYOND_CLAMP (there is no law of slow impacts "
      "of these bodies)");
}

SlowLaw law_at_wall(const stoss_body& body) {
  if (body.rigid) no_law();
  if (const auto* disk = std::get_if<Disk>(&body.value)) return slow_law(*disk);
  if (const auto* sphere = std::get_if<Sphere>(&body.value)) return slow_law(*sphere);
  no_law();
}

SlowLaw law_of_two(const stoss_body& first, const stoss_body& second) {
  const auto* ball = std::get_if<Sphere>(&first.value);
  const auto* block = std::get_if<HalfSpace>(&second.value);
  if (ball && block && !second.rigid) return slow_law(*ball, *block, first.rigid);
  if (first.rigid || second.rigid) no_law();
  const auto* other_ball = std::get_if<Sphere>(&second.value);
  if (ball && other_ball) return slow_law(*ball, *other_ball);
  const auto *disk = std::get_if<Disk>(&first.value), *other_disk = std::get_if<Disk>(&second.value);
  if (disk && other_disk) return slow_law(*disk, *other_disk);
  no_law();
}

}  // namespace

SlowLaw law_of(const stoss_contact& contact) {
  return contact.second ? law_of_two(contact.first, *contact.second) : law_at_wall(contact.first);
}

}  // namespace stoss::c
