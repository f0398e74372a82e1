#include "output/fields.hpp"

namespace stoss::cli {

Units units_of(const Encounter& encounter) {
  const Kind& first = kind(encounter.first.kind);
  return {first.own, first.si, si_scales(encounter)};
}

Columns input_columns(const std::string& name, Dimension dimension, const Units& units, int width) {
  if (!units.si) return {{name, units.own_name(dimension), width}};
  return {{name, units.own_name(dimension)}, {name + "_si", std::string(unit_name(dimension, units.in_si)), width}};
}

Row input_row(double value, Dimension dimension, const Units& units) {
  if (!units.si) return {value};
  return {value, value * unit_in_si(dimension, *units.si)};
}

Columns speed_columns(const Units& units) { return input_columns("speed", Dimension::speed, units, 12); }

Row speed_row(const Units& units, double speed) { return input_row(speed, Dimension::speed, units); }

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

void warn_of_materials(const OutputOptions& output, const Encounter& encounter, double fastest) {
  const std::optional<Scales> si = si_scales(encounter);
  if (!si) return;
  for (const std::string& line : material_warnings(encounter, fastest * si->speed)) output.warn(line);
}

}  // namespace stoss::cli
