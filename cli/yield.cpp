#include "yield.hpp"

#include <fmt/format.h>

namespace stoss::cli {

void add_yield(Record& record, const Units& units, const std::optional<double>& yield_speed, double speed) {
  if (!yield_speed) return;
  record.push_back({"yield_speed", units.own_name(Dimension::speed), *yield_speed / units.si->speed});
  record.push_back({"yield_speed_si", units.si_name(Dimension::speed), *yield_speed});
  record.push_back({"beyond_yield", "", speed * units.si->speed > *yield_speed});
}

std::string yield_warning(double yield_speed) {
  return fmt::format("speed above {:.4g} m/s, where yielding begins (beyond_yield): eps is an upper bound there",
                     yield_speed);
}

}  // namespace stoss::cli
