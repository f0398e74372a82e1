#pragma once

#include <cstdint>
#include <functional>

#include "output/output.hpp"
#include "output/rows.hpp"

namespace stoss::cli {

/// Reads the rows that an earlier run of the same job, perhaps killed, has left in its CSV file, without changing it.
/// Where the file is empty, or has only a part of its header, nothing has been done yet. An incomplete last line is
/// left out, and so is the line that tells of an interruption.
/// @param provenance of the present job; the file must have the same inputs
/// @param visit      called with each complete row, in order; what it throws ends the reading
/// @return bytes up to the end of the last complete row; 0: nothing to keep
/// @throws InvalidInput if the file is not one of this job; OutputError if it cannot be read
[[nodiscard]] std::uintmax_t read_earlier(const Output& output, const Provenance& provenance, const Columns& columns,
                                          const std::function<void(const Row&)>& visit);

}  // namespace stoss::cli
