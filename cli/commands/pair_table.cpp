#include "commands/pair_table.hpp"

#include <fmt/format.h>

#include <vector>

#include "output/writer.hpp"
#include "process/text.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {

PairTable compute_pairs(const Encounter& encounter, double slowest, double fastest, const std::string& ratio,
                        const PairTableOptions& options) {
  const std::vector<std::string> ends = split(ratio, ':');
  if (ends.size() != 2) throw InvalidInput(fmt::format("ratio: got '{}', allowed SMALLEST:GREATEST, as in 1:3", ratio));
  return pair_table(mixture(encounter), slowest, fastest, parse_number("ratio", ends[0]),
                    parse_number("ratio", ends[1]), options);
}

std::string pairs_as_json(const PairTable& table, const TableLabel& label, const Provenance& provenance) {
  auto document = json_document(provenance);
  document["units"]["speed"] = label.unit;
  document["interpolation"] = "cubic Hermite in ln(speed) and in s = (ratio - 1)/(ratio + 1)";
  document["greatest_error"] = table.greatest_error();
  const PairValues& values = table.values();
  document["inverse_is_same"] = values.alike;
  document["ratio"] = values.ratios;
  const std::size_t columns = values.ratios.size();
  for (std::size_t k = 0; k < values.speeds.size(); ++k) {
    nlohmann::ordered_json record{{"speed", values.speeds[k] * label.scale}};
    const PairTable::Node* node = &table.nodes()[k * columns];
    for (std::size_t j = 0; j < columns; ++j) {
      record["restitution"].push_back(node[j].value);
      record["restitution_error"].push_back(values.restitution[k * columns + j].error);
      record["slope_of_speed"].push_back(node[j].by_speed);
      record["slope_of_ratio"].push_back(node[j].by_ratio);
      record["slope_of_both"].push_back(node[j].by_both);
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
