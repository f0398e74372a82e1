#pragma once

#include <nlohmann/json.hpp>

#include "output/fields.hpp"
#include "output/output_options.hpp"
#include "output/rows.hpp"
#include "stoss/restitution/oblique.hpp"

namespace stoss::cli {

/// The columns of `stoss oblique` behind the motion before. A table of spinning bodies has no room for both errors.
[[nodiscard]] Fields<ObliqueRestitution> oblique_fields(const Units& units, bool spinning);

/// What JSON has in addition.
[[nodiscard]] nlohmann::ordered_json oblique_details(const ObliqueRestitution& result);

/// What is said at the end of the coupling that spheres are computed without.
class NeglectedNote {
 public:
  /// Takes note of a row, also of an earlier run.
  void take(const Columns& columns, const Row& row);

  /// Warns below a table, which has no column for it, if it may change a tangential restitution by more than was asked
  /// for, or by an unknown amount.
  void say(const OutputOptions& output, double tolerance) const;

 private:
  double tangential_ = 0.0, normal_ = 0.0;  // largest changes
  bool unknown_ = false;
};

}  // namespace stoss::cli
