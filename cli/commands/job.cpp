#include "commands/job.hpp"

#include <fmt/format.h>

namespace stoss::cli {

RefinableContact Job::contact(double poisson) const {
  Encounter its = encounter;
  if (!units.si && !is_rod(its)) its.first.values["poisson"] = poisson;
  return refinable(its);
}

Row Job::key(std::size_t row) const {
  Row key;
  if (!is_rod(encounter)) key.emplace_back(poisson(row));
  append(key, speed_row(units, speed(row)));
  return key;
}

RowPlan Job::plan(const Columns& results) const {
  Columns columns;
  if (!is_rod(encounter)) columns.push_back({"poisson", "", units.si ? 0 : 8});
  append(columns, speed_columns(units));
  append(columns, results);
  append(columns, yielding(encounter).columns());
  const auto name = [this](std::size_t row) {
    const std::string body = is_rod(encounter) ? "" : fmt::format("poisson {}, ", poisson(row));
    return fmt::format("{}speed {:.6g} c", body, speed(row));
  };
  return {.size = size(),
          .columns = columns,
          .key = [this](std::size_t row) { return key(row); },
          .name = name,
          .yield_speed = yield_speed(encounter)};
}

}  // namespace stoss::cli
