#pragma once

#include <optional>
#include <string>

#include "report.hpp"
#include "stoss/impact/impact.hpp"
#include "units.hpp"

namespace stoss::cli {

/// The instants of an impact as CSV. The file is opened with the first one, so that a refused impact leaves it alone.
class Trajectory {
 public:
  Trajectory(std::string path, Provenance provenance, const Units& units)
      : path_(std::move(path)), provenance_(std::move(provenance)), units_{.own = units.own} {}

  /// @throws Interrupted after Ctrl-C or SIGTERM, when the file is complete so far; OutputError
  void write(const Snapshot& now);

  void finish();

 private:
  std::string path_;
  Provenance provenance_;
  Units units_;  ///< of the first body only
  std::optional<Report> report_;
};

}  // namespace stoss::cli
