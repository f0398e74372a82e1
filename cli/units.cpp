#include "units.hpp"

#include <array>

namespace stoss::cli {
namespace {

struct Kind {
  std::string_view name;
  UnitSystem own;
  UnitSystem si;
};

// In the order of BodyKind.
constexpr std::array<Kind, 3> kinds{{{"disk", UnitSystem::disk, UnitSystem::disk_si},
                                     {"sphere", UnitSystem::sphere, UnitSystem::sphere_si},
                                     {"rod", UnitSystem::rod, UnitSystem::rod_si}}};

const Kind& of(BodyKind kind) { return kinds.at(static_cast<std::size_t>(kind)); }

}  // namespace

std::string_view name(BodyKind kind) { return of(kind).name; }

BodyKind body_kind(std::string_view text) {
  if (text == name(BodyKind::rod)) return BodyKind::rod;
  return text == name(BodyKind::sphere) ? BodyKind::sphere : BodyKind::disk;
}

std::string Units::own_name(Dimension dimension) const { return std::string(unit_name(dimension, of(body).own)); }

std::string Units::si_name(Dimension dimension) const { return std::string(unit_name(dimension, of(body).si)); }

double Units::scale(Dimension dimension) const { return unit_in_si(dimension, *si); }

}  // namespace stoss::cli
