#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "csv.hpp"
#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

/// To the six digits that fit a table.
std::string for_reading(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:.6g}", *number);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "yes" : "no";
  return full_precision(value);
}

nlohmann::ordered_json to_json(const Value& value) {
  return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

/// Pads on the left to a width in characters (UTF-8 continuation bytes do not count).
std::string right_aligned(const std::string& text, int width) {
  int length = 0;
  for (const char c : text) length += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;
  return std::string(static_cast<std::size_t>(std::max(width - length, 0)), ' ') + text;
}

std::string table_head(const Record& record) {
  std::string names;
  std::string units;
  for (const Entry& entry : record) {
    if (entry.width == 0) continue;
    names += right_aligned(entry.key, entry.width);
    units += right_aligned(entry.unit, entry.width);
  }
  units.erase(units.find_last_not_of(' ') + 1);
  return names + "\n" + units + "\n";
}

std::string table_row(const Record& record) {
  std::string text;
  for (const Entry& entry : record) {
    if (entry.width == 0) continue;
    text += right_aligned(entry.shown.empty() ? for_reading(entry.value) : entry.shown, entry.width);
  }
  return text;
}

}  // namespace

nlohmann::ordered_json json_document(Provenance provenance) {
  nlohmann::ordered_json document;
  document["schema"] = fmt::format("stoss/{}/2", provenance.schema);
  document["version"] = version();
  document["command"] = std::move(provenance.command);
  document["inputs"] = std::move(provenance.inputs);
  document["units"] = nlohmann::ordered_json::object();
  document["records"] = nlohmann::ordered_json::array();
  return document;
}

std::string json_text(const nlohmann::ordered_json& document) {
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Report::Report(Output output, Format format, Provenance provenance) : format_(format), output_(std::move(output)) {
  if (format_ == Format::csv) {
    output_.write(csv_header(provenance));
  } else if (format_ == Format::json) {
    document_ = json_document(std::move(provenance));
  }
}

Report::Report(Output output, std::uintmax_t size) : format_(Format::csv), begun_(true), output_(std::move(output)) {
  output_.keep(size);
}

void Report::begin(const Record& record) {
  begun_ = true;
  if (format_ == Format::csv) {
    output_.write(csv_columns(record) + "\n");
  } else if (format_ == Format::table) {
    output_.write(table_head(record));
  } else {
    for (const Entry& entry : record) {
      if (!entry.unit.empty()) document_["units"][entry.key] = entry.unit;
    }
  }
}

void Report::add(const Record& record, const nlohmann::ordered_json& details) {
  if (!begun_) begin(record);
  if (format_ == Format::json) {
    nlohmann::ordered_json object;
    for (const Entry& entry : record) object[entry.key] = to_json(entry.value);
    object.update(details);
    document_["records"].push_back(std::move(object));
    return;
  }
  output_.write((format_ == Format::csv ? csv_row(record) : table_row(record)) + "\n");
  output_.end_row();
}

void Report::close_table(const std::string& lines) { output_.write(lines); }

void Report::attach(const std::string& key, nlohmann::ordered_json value) { document_[key] = std::move(value); }

void Report::finish(bool complete) {
  if (!complete && !begun_) return;
  if (format_ == Format::json) {
    document_["complete"] = complete;
    output_.write(json_text(document_));
  } else if (!complete) {
    output_.write(fmt::format("{}\n", csv_interrupted));
  }
  output_.close();
}

void Report::finish_after(const std::function<void()>& add_all) {
  try {
    add_all();
  } catch (const OutputError&) {
    throw;
  } catch (...) {
    finish(false);
    throw;
  }
  finish();
}

}  // namespace stoss::cli
