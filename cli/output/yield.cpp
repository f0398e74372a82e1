#include "output/yield.hpp"

#include <fmt/format.h>

namespace stoss::cli {

Columns Yielding::columns() const {
  if (!speed) return {};
  return {{"yield_speed", units.own_name(Dimension::speed)},
          {"yield_speed_si", std::string(unit_name(Dimension::speed, units.in_si))},
          {"beyond_yield"}};
}

Row Yielding::row(double impact) const {
  if (!speed) return {};
  return {*speed / units.si->speed, *speed, is_below(impact)};
}

std::string yield_warning(double yield_speed) {
  return fmt::format("speed above {:.4g} m/s, where yielding begins (beyond_yield): eps is an upper bound there",
                     yield_speed);
}

}  // namespace stoss::cli
