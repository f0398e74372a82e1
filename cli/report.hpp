#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "output.hpp"
#include "record.hpp"

namespace stoss::cli {

enum class Format { table, csv, json };

/// The JSON document of an output without records: schema, version, command, inputs, units, records.
[[nodiscard]] nlohmann::ordered_json json_document(Provenance provenance);

/// As it is written.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& document);

/// Records as a table, as CSV or as JSON. Tables and CSV are written record by record, JSON at the end.
class Report {
 public:
  /// The output is to have nothing else.
  Report(Output output, Format format, Provenance provenance);

  /// Continues the rows of a CSV file after its first `size` bytes.
  Report(Output output, std::uintmax_t size);

  /// The first record also gives the header.
  /// @param details members of the JSON record, in place of entries of the same key or after them
  void add(const Record& record, const nlohmann::ordered_json& details = nlohmann::ordered_json::object());

  /// Lines below the rows of a table.
  void close_table(const std::string& lines);

  /// A member of the JSON document in addition to its records.
  void attach(const std::string& key, nlohmann::ordered_json value);

  /// Writes what is still to be written; without a record, and not complete, nothing. @throws OutputError
  void finish(bool complete = true);

  /// Finishes after `add_all`, as incomplete if that throws.
  void finish_after(const std::function<void()>& add_all);

 private:
  void begin(const Record& record);

  Format format_;
  bool begun_ = false;
  nlohmann::ordered_json document_;
  Output output_;
};

}  // namespace stoss::cli
