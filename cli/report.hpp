#pragma once

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace stoss::cli {

/// Output that could not be written; the command exits with 4.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file, or stdout when the path is empty or "-". Every write is checked.
class Output {
 public:
  explicit Output(const std::string& path);
  void write(const std::string& text);
  void flush();
  void close();

 private:
  [[noreturn]] void fail() const;
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

enum class Format { table, csv, json };

using Value = std::variant<double, long, bool, std::string>;

/// One quantity of a record.
struct Entry {
  std::string key;   ///< its name in JSON, CSV and the table
  std::string unit;  ///< "" for a pure number
  Value value;
  int width = 0;           ///< of its column in the table; 0: not shown there
  std::string shown = {};  ///< what the table shows, if not the value
};

/// What made the data: written at the head of CSV and JSON.
struct Provenance {
  std::string schema;   ///< name of the record, as in "restitution"
  std::string command;  ///< the command line
  nlohmann::ordered_json inputs;
};

/// Records as a table, as CSV or as JSON. Tables and CSV are written record by record, JSON at the end.
class Report {
 public:
  Report(const std::string& path, Format format, Provenance provenance);

  /// The first record also gives the header.
  void add(const std::vector<Entry>& record);

  /// A member of the JSON document beside its records.
  void attach(const std::string& key, nlohmann::ordered_json value);

  /// Writes what is still to be written. @throws OutputError
  void finish(bool complete = true);

 private:
  void begin(const std::vector<Entry>& record);

  Format format_;
  Provenance provenance_;
  bool begun_ = false;
  nlohmann::ordered_json document_;
  Output output_;
};

}  // namespace stoss::cli
