#include "units.hpp"

namespace stoss::cli {

std::string Units::own_name(Dimension dimension) const {
  return std::string(unit_name(dimension, rods ? UnitSystem::rod : UnitSystem::disk));
}

std::string Units::si_name(Dimension dimension) const {
  return std::string(unit_name(dimension, rods ? UnitSystem::rod_si : UnitSystem::disk_si));
}

double Units::scale(Dimension dimension) const { return unit_in_si(dimension, *si); }

}  // namespace stoss::cli
