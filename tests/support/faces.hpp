#pragma once

#include <string>

#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "support/csv.hpp"

namespace stoss::test {

/// Who meets whom in a row of validate/data/reference_faces.csv, whose columns are the command's options.
[[nodiscard]] inline Encounter encounter_of_faces(const CsvRow& row) {
  Encounter encounter;
  Participant &first = encounter.first, &met = encounter.against;
  first.kind = row.text("body"), met.kind = row.text("against");
  for (const char* name : {"poisson", "loss_time", "u0", "coat", "coat_young", "coat_quality"}) {
    if (row.has(name)) first.values[name] = row.number(name);
  }
  for (const char* name : {"hardness", "poisson", "radius", "young"}) {
    const std::string column = std::string("against_") + name;
    if (row.has(column)) met.values[name] = row.number(column);
  }
  if (row.has("terms")) first.relaxation = parse_relaxation("terms", row.text("terms"));
  return encounter;
}

}  // namespace stoss::test
