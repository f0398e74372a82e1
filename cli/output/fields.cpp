#include "output/fields.hpp"

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

}  // namespace stoss::cli
