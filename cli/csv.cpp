#include "csv.hpp"

#include <fmt/format.h>

#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

std::string joined(const Record& record, std::string (*cell)(const Entry&)) {
  std::string text;
  for (const Entry& entry : record) {
    if (&entry != &record.front()) text += ',';
    text += cell(entry);
  }
  return text;
}

}  // namespace

std::string full_precision(const Value& value) {
  return std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
}

std::string csv_origin(const Provenance& provenance) {
  return fmt::format("# stoss {}: {}", version(), provenance.schema);
}

std::vector<std::pair<std::string, std::string>> csv_inputs(const Provenance& provenance) {
  std::vector<std::pair<std::string, std::string>> inputs;
  for (const auto& [key, value] : provenance.inputs.items()) {
    inputs.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return inputs;
}

std::string csv_header(const Provenance& provenance) {
  std::string text = fmt::format("{}\n# command: {}\n", csv_origin(provenance), provenance.command);
  for (const auto& [key, value] : csv_inputs(provenance)) text += fmt::format("# {}: {}\n", key, value);
  return text;
}

std::string csv_columns(const Record& record) {
  return joined(record, [](const Entry& entry) {
    return entry.unit.empty() ? entry.key : fmt::format("{}[{}]", entry.key, entry.unit);
  });
}

std::string csv_row(const Record& record) {
  return joined(record, [](const Entry& entry) { return full_precision(entry.value); });
}

}  // namespace stoss::cli
