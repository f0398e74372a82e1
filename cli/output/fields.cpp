#include "output/fields.hpp"

#include <fmt/format.h>

namespace stoss::cli {

Units units_of(const Encounter& encounter) {
  const Kind& first = kind(encounter.first.kind);
  return {first.own, first.si, si_scales(encounter)};
}

Columns speed_columns(const Units& units) {
  constexpr int width = 12;
  if (!units.si) return {{"speed", units.own_name(Dimension::speed), width}};
  return {{"speed", units.own_name(Dimension::speed)}, {"speed_si", "m/s", width}};
}

Row speed_row(const Units& units, double speed) {
  if (!units.si) return {speed};
  return {speed, speed * units.si->speed};
}

nlohmann::ordered_json to_json(const Columns& columns, const Row& row) {
  auto object = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < row.size(); ++i) {
    object[columns[i].name] = std::visit([](const auto& its) { return nlohmann::ordered_json(its); }, row[i]);
  }
  return object;
}

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
