#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/output_options.hpp"
#include "stoss/table/c_source.hpp"

namespace stoss::cli {

/// What stoss table is given.
struct TableArguments {
  EncounterOptions who;
  ApproachOptions approach;
  std::string ratio;  // of a table of pairs
  double error = 1e-3;
  bool oblique = false;              // the whole collision rule
  double tolerance = 2e-2;           // of s′
  std::optional<double> friction{};  // of a rule that depends on it
  bool predicted = false;            // with yield and adhesion
  std::optional<double> adhesion{};  // J/m²
  int threads = 0;
  std::string format = "c";
  std::string name = "stoss";
  std::string beyond = "clamp";
  OutputOptions output;  // but for its format
  CLI::App* command = nullptr;
};

/// What it makes of it.
struct TableJob {
  Encounter encounter;
  std::vector<double> typed;   ///< ends of the range, m/s with a material
  std::vector<double> speeds;  ///< the same in c
  bool si = units_of(encounter).si.has_value();
  double unit = speed_unit(encounter);  ///< m/s, or 1
  std::string unit_name = si ? "m/s" : "c";
  std::optional<double> by_models{};  ///< the largest spread of the models, once it is computed
};

[[nodiscard]] Beyond beyond(const TableArguments& arguments);

/// What a table as code says of itself.
[[nodiscard]] TableLabel label(const TableArguments& arguments, const TableJob& job);

/// Whether a form is source code, whose names begin with --name.
[[nodiscard]] inline bool is_code(const std::string& format) {
  return format == "c" || format == "rust" || format == "js";
}

/// A table of any kind as code.
template <typename Table>
[[nodiscard]] std::string code(const TableArguments& arguments, const TableJob& job, const Table& table) {
  const TableLabel its = label(arguments, job);
  if (arguments.format == "rust") return rust_module(table, its);
  return arguments.format == "js" ? js_module(table, its) : c_header(table, its);
}

/// What all kinds of table have besides their records. @param between how values between the knots are to be had
/// @param error the greatest of ε
[[nodiscard]] nlohmann::ordered_json json_head(const TableArguments& arguments, const TableJob& job,
                                               const std::string& between, double error);

/// The ends of --ratio.
[[nodiscard]] std::pair<double, double> ratios_of(const TableArguments& arguments);

/// The whole documents.
[[nodiscard]] std::string as_json(const TableArguments& arguments, const TableJob& job,
                                  const RestitutionFunction& function);
[[nodiscard]] std::string as_json(const TableArguments& arguments, const TableJob& job, const PairTable& table);

/// The table of --oblique.
[[nodiscard]] std::string text_of_rule(const TableArguments& arguments, const TableJob& job);

/// The same as a file, made by the Python package, which this process becomes.
[[noreturn]] void write_netcdf_of_rule(const TableArguments& arguments, const TableJob& job);

}  // namespace stoss::cli
