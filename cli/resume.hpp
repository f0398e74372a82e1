#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "output.hpp"
#include "record.hpp"

namespace stoss::cli {

/// How far an earlier run of the same job, perhaps killed, came in its CSV file.
struct Earlier {
  std::uintmax_t size = 0;  ///< bytes up to the end of the last complete row; 0: nothing to keep
  std::size_t rows = 0;
};

/// Called with the cells of each complete row, in order. What it throws ends the reading.
using RowVisitor = std::function<void(std::size_t index, const std::vector<std::string>& cells)>;

/// Reads a CSV file without changing it. Where it is empty, or has only a part of its header, nothing has been done
/// yet. An incomplete last line is left out, and so is the line that tells of an interruption.
/// @param provenance of the present job; the file must have the same inputs
/// @param columns    as csv_columns writes them
/// @throws InvalidInput if the file is not one of this job; OutputError if it cannot be read
[[nodiscard]] Earlier read_earlier(const Output& output, const Provenance& provenance, const std::string& columns,
                                   const RowVisitor& visit);

}  // namespace stoss::cli
