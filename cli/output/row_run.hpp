#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "output/output_options.hpp"
#include "output/writer.hpp"
#include "stoss/encounter/encounter.hpp"

namespace stoss::cli {

/// What an earlier run has left.
struct Earlier {
  std::uintmax_t size = 0;  ///< bytes up to the end of the last complete row; 0: nothing to keep
  bool checked = false;     ///< rows end with a checksum
};

/// Reads the rows that an earlier run of the same job, perhaps killed, has left in its CSV file, without changing it.
/// Where the file is empty, or has only a part of its header, nothing has been done yet. An incomplete last line is
/// left out, and so is the line that tells of an interruption.
/// @param provenance of the present job; the file must have the same inputs
/// @param visit      called with each complete row, in order; what it throws ends the reading
/// Where rows have a checksum, each must be that of its row.
/// @return what to keep
/// @throws InvalidInput if the file is not one of this job; OutputError if it cannot be read
[[nodiscard]] Earlier read_earlier(const Output& output, const Provenance& provenance, const Columns& columns,
                                   const std::function<void(const Row&)>& visit);

/// What rows there will be.
struct RowPlan {
  std::size_t size = 0;
  Columns columns;
  std::function<Row(std::size_t row)> key;           ///< with which this row begins, and no other
  std::function<std::string(std::size_t row)> name;  ///< of a row, in warnings
  std::optional<Encounter> encounter{};              ///< for warnings of its materials
  std::function<void(const Row& row)> observer{};    ///< called with each row, also those of an earlier run
};

/// Rows that are computed one after the other and written after those that an earlier run has left.
class RowRun {
 public:
  RowRun(RowPlan plan, const RowOptions& options);

  /// Writes the rows that `compute` adds, and closes the output, complete or not.
  /// @throws Interrupted, OutputError, InvalidInput for a file of another job, and what `compute` throws
  void write(const Provenance& provenance, const std::function<void()>& compute);

  /// Writes the next row, within `write`. @throws OutputError
  /// @param details for JSON only
  /// @param trouble why its value is not what was asked for
  void add(const Row& row, const nlohmann::ordered_json& details, const std::string& trouble);

  /// Says on a terminal what the next row has come to, if it takes long.
  void wait(const std::string& state) { progress_.wait(state); }

  [[nodiscard]] std::size_t done() const { return done_; }

  /// Within `write`.
  [[nodiscard]] Writer& writer() { return *writer_; }

  /// Warns of rows without the value that was asked for. @throws NotAsAsked if there are any
  void conclude() const;

 private:
  [[nodiscard]] Writer open(const Provenance& provenance);
  void take(const Row& row);
  void count(const Row& row);

  RowPlan plan_;
  const RowOptions& options_;
  Progress progress_;
  std::optional<Writer> writer_;
  std::size_t done_ = 0;
  std::size_t marked_ = 0;
  bool stays_ = false;
  double least_ = 1.0;                  // ε above 0
  double strain_ = 0.0, turned_ = 0.0;  ///< greatest of the rows that are beyond what is small
  double fastest_ = 0.0;                ///< speed of the fastest row, c of the first body
};

}  // namespace stoss::cli
