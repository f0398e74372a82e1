#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "stoss/quantity.hpp"

namespace stoss::cli {

/// One quantity of a record.
struct Entry {
  std::string key;   ///< its name in JSON, CSV and the table
  std::string unit;  ///< "" for a pure number
  Value value;
  int width = 0;           ///< of its column in the table; 0: not shown there
  std::string shown = {};  ///< what the table shows, if not the value
};

using Record = std::vector<Entry>;

/// The text in place of an error that is not known.
inline constexpr std::string_view unknown = "unknown";

/// What made the data: written at the head of CSV and JSON.
struct Provenance {
  std::string schema;   ///< name of the record, as in "restitution"
  std::string command;  ///< the command line
  nlohmann::ordered_json inputs;
};

}  // namespace stoss::cli
