#include "job.hpp"

#include <fmt/format.h>

namespace stoss::cli {

RefinableContact Job::contact(double poisson) const {
  Encounter its = encounter;
  if (!units.si && !is_rod(its)) its.first.values["poisson"] = poisson;
  return refinable(its);
}

Record Job::key(std::size_t row) const {
  Record record;
  if (!is_rod(encounter)) record.push_back({"poisson", "", poisson(row), units.si ? 0 : 8});
  record.push_back({"speed", units.own_name(Dimension::speed), speed(row), units.si ? 0 : 12});
  if (units.si) record.push_back({"speed_si", "m/s", speed(row) * units.si->speed, 12});
  return record;
}

Rows Job::rows(const std::string& columns) const {
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
