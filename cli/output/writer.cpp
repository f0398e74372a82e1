#include "output/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/fields.hpp"
#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

/// To the six digits that fit a table.
std::string for_reading(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    return std::isnan(*number) ? std::string("-") : fmt::format("{:.6g}", *number);
  }
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "yes" : "no";
  return full_precision(value);
}

/// Adds a cell of a table, padded on the left to a width in characters (UTF-8 continuation bytes do not count), and
/// after at least one space where a cell is before it: a long one does not run into its neighbour.
void append_cell(std::string& line, const std::string& text, int width) {
  int length = 0;
  for (const char c : text) length += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;
  const int apart = line.empty() || text.empty() ? 0 : 1;
  line += std::string(static_cast<std::size_t>(std::max(width - length, apart)), ' ') + text;
}

std::string table_head(const Columns& columns) {
  std::string names, units;
  for (const Column& column : columns) {
    if (column.width == 0) continue;
    append_cell(names, column.name, column.width);
    append_cell(units, column.unit, column.width);
  }
  units.erase(units.find_last_not_of(' ') + 1);
  return names + "\n" + units + "\n";
}

std::string table_row(const Columns& columns, const Row& row) {
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const Column& column = columns[i];
    if (column.width == 0) continue;
    std::string cell = for_reading(row[i]);
    if (column.with_error) {
      cell = with_error(number(row[i]), number(row[i + 1]));
    } else if (i + 1 < row.size() && columns[i + 1].name == column.name + "_error" &&
               row[i + 1] == Value(std::string(unknown))) {
      cell = unknown;
    }
    if (column.mark) cell += has(columns, row, column.mark->first, column.mark->second) ? " !" : "  ";
    append_cell(text, cell, column.width);
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

Writer::Writer(Output output, Format format, Provenance provenance, Columns columns, bool checked)
    : format_(format), columns_(std::move(columns)), checked_(checked), output_(std::move(output)) {
  if (format_ == Format::csv) output_.write(csv_header(provenance));
  if (format_ == Format::json) document_ = json_document(std::move(provenance));
}

Writer::Writer(Output output, std::uintmax_t size, bool checked)
    : format_(Format::csv), begun_(true), checked_(checked), output_(std::move(output)) {
  output_.keep(size);
}

void Writer::begin() {
  begun_ = true;
  if (format_ == Format::csv) {
    output_.write(csv_columns(columns_) + (checked_ ? "," + std::string(csv_checksum) : "") + "\n");
  }
  if (format_ == Format::table) output_.write(table_head(columns_));
  if (format_ != Format::json) return;
  for (const Column& column : columns_) {
    if (!column.unit.empty()) document_["units"][column.name] = column.unit;
  }
}

void Writer::add(const Row& row, const nlohmann::ordered_json& details) {
  if (!begun_) begin();
  if (format_ == Format::json) {
    nlohmann::ordered_json object = to_json(columns_, row);
    object.update(details);
    document_["records"].push_back(std::move(object));
    return;
  }
  const std::string text = format_ == Format::csv ? csv_row(row) : table_row(columns_, row);
  output_.write((format_ == Format::csv && checked_ ? with_checksum(text) : text) + "\n");
  output_.end_row();
}

void Writer::finish(bool complete) {
  if (!complete && !begun_) return;
  if (format_ == Format::json) {
    document_["complete"] = complete;
    output_.write(json_text(document_));
  } else if (!complete) {
    output_.write(fmt::format("{}\n", csv_interrupted));
  }
  output_.close();
}

void Writer::finish_after(const std::function<void()>& add_all) {
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
