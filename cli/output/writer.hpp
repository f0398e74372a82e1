#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "output/output.hpp"
#include "output/rows.hpp"

namespace stoss::cli {

enum class Format { table, csv, json };

/// The JSON document of an output without records: schema, version, command, inputs, units, records.
[[nodiscard]] nlohmann::ordered_json json_document(Provenance provenance);

/// As it is written.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& document);

/// Writes rows as a table, as CSV or as JSON. Tables and CSV are written row by row, JSON at the end.
class Writer {
 public:
  /// The output is to have nothing else.
  /// @param checked each row of CSV ends with its checksum
  Writer(Output output, Format format, Provenance provenance, Columns columns, bool checked = false);

  /// Continues the rows of a CSV file after its first `size` bytes.
  Writer(Output output, std::uintmax_t size, bool checked);

  /// The first row also gives the header.
  /// @param details members of the JSON record, in place of columns of the same name or after them
  void add(const Row& row, const nlohmann::ordered_json& details = nlohmann::ordered_json::object());

  /// Lines below the rows of a table.
  void close_table(const std::string& lines) { output_.write(lines); }

  /// A member of the JSON document in addition to its records.
  void attach(const std::string& key, nlohmann::ordered_json value) { document_[key] = std::move(value); }

  /// Writes what is still to be written; without a row, and not complete, nothing. @throws OutputError
  void finish(bool complete = true);

  /// Finishes after `add_all`, as incomplete if that throws.
  void finish_after(const std::function<void()>& add_all);

 private:
  void begin();

  Format format_;
  Columns columns_;
  bool begun_ = false, checked_ = false;
  nlohmann::ordered_json document_;
  Output output_;
};

}  // namespace stoss::cli
