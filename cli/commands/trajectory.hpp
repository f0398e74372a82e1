#pragma once

#include <optional>
#include <string>
#include <utility>

#include "output/fields.hpp"
#include "output/writer.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss::cli {

/// The instants of an impact as CSV. The file is opened with the first one, so that a refused impact leaves it alone.
class Trajectory {
 public:
  Trajectory(std::string path, Provenance provenance, const Units& units);

  /// @throws Interrupted after Ctrl-C or SIGTERM, when the file is complete so far; OutputError
  void write(const Snapshot& now);

  void finish();

 private:
  std::string path_;
  Provenance provenance_;
  Fields<Snapshot> fields_;  // in units of the first body only
  std::optional<Writer> writer_;
};

}  // namespace stoss::cli
