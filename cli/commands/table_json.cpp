// JSON documents of stoss table: computed values, slopes and errors.
#include <cstddef>
#include <string>
#include <utility>

#include "commands/table.hpp"

namespace stoss::cli {
std::string as_json(const TableArguments& arguments, const TableJob& job, const RestitutionFunction& function) {
  auto document = json_head(arguments, job, "ln(speed)", function.greatest_error());
  const TableValues& values = function.values();
  const std::size_t last = values.speeds.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    const double speed = k == 0 ? job.typed[0] : k == last ? job.typed[1] : values.speeds[k] * job.unit;
    nlohmann::ordered_json record{{"speed", speed},
                                  {"restitution", values.values[k].value},
                                  {"restitution_error", values.values[k].error},
                                  {"slope", function.nodes()[2 * k + 1]}};
    if (k < last) record["error_to_next"] = function.errors()[k];
    document["records"].push_back(std::move(record));
  }
  document["complete"] = true;
  return json_text(document);
}

std::string as_json(const TableArguments& arguments, const TableJob& job, const PairTable& table) {
  auto document = json_head(arguments, job, "ln(speed) and in s = (ratio - 1)/(ratio + 1)", table.greatest_error());
  const TableValues& values = table.values();
  document["inverse_is_same"] = values.alike;
  document["ratio"] = values.ratios;
  const std::size_t columns = values.ratios.size();
  for (std::size_t k = 0; k < values.speeds.size(); ++k) {
    nlohmann::ordered_json record{{"speed", values.speeds[k] * job.unit}};
    for (std::size_t j = 0; j < columns; ++j) {
      const double* node = &table.nodes()[4 * (k * columns + j)];
      record["restitution"].push_back(node[0]);
      record["restitution_error"].push_back(values.values[k * columns + j].error);
      record["slope_of_speed"].push_back(node[1]);
      record["slope_of_ratio"].push_back(node[2]);
      record["slope_of_both"].push_back(node[3]);
      if (k + 1 < values.speeds.size() && j + 1 < columns) {
        record["error_to_next"].push_back(table.errors()[k * (columns - 1) + j]);
      }
    }
    document["records"].push_back(std::move(record));
  }
  document["complete"] = true;
  return json_text(document);
}

}  // namespace stoss::cli
