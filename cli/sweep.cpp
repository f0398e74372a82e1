#include "sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "csv.hpp"
#include "stoss/errors.hpp"
#include "text.hpp"
#include "yield.hpp"

namespace stoss::cli {

Record Job::key(std::size_t row) const {
  Record record;
  if (!encounter.rods()) record.push_back({"poisson", "", poisson(row), units.si ? 0 : 8});
  record.push_back({"speed", units.own_name(Dimension::speed), speed(row), units.si ? 0 : 12});
  if (units.si) record.push_back({"speed_si", "m/s", speed(row) * units.si->speed, 12});
  return record;
}

Sweep::Sweep(Job job, const OutputArguments& output, const std::string& columns)
    : job_(std::move(job)), output_(output), columns_(split(columns, ',')), progress_(output, job_.size()) {}

bool Sweep::has(const std::vector<std::string>& cells, const std::string& column, const std::string& value) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  return found != columns_.end() && cells[static_cast<std::size_t>(found - columns_.begin())] == value;
}

void Sweep::count(const std::vector<std::string>& cells) {
  if (has(cells, "converged", "false") || has(cells, "restitution", "nan")) ++marked_;
  if (has(cells, "beyond_small_strain", "true")) beyond_small_strain_ = true;
  if (has(cells, "beyond_yield", "true")) beyond_yield_ = true;
  ++done_;
}

void Sweep::take(const std::vector<std::string>& cells) {
  if (done_ == job_.size()) {
    throw InvalidInput(
        fmt::format("resume: got a row {} in the file, allowed {} (mend it, or write another file)", done_ + 1, done_));
  }
  const Record key = job_.key(done_);
  const std::vector<std::string> first(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(key.size()));
  const std::string got = fmt::format("{}", fmt::join(first, ","));
  const std::string expected = csv_row(key);
  if (got != expected) {
    throw InvalidInput(
        fmt::format("resume: got {} {} in row {} of the file, allowed {} (mend it, or write another file)",
                    csv_columns(key), got, done_ + 1, expected));
  }
  count(cells);
}

void Sweep::add(const Row& row, Report& report) {
  progress_.hide();
  report.add(row.record, row.details);
  if (!row.trouble.empty()) {
    const std::string body = job_.encounter.rods() ? "" : fmt::format("poisson {}, ", job_.poisson(done_));
    output_.warn(fmt::format("{}speed {:.6g} c: {}", body, job_.speed(done_), row.trouble));
  }
  count(split(csv_row(row.record), ','));
  progress_.show(done_);
}

int Sweep::conclude() const {
  if (beyond_small_strain_) {
    output_.warn("speed above 0.5 c or compression above 0.5 R: linear elasticity has lost its meaning there");
  }
  if (beyond_yield_) output_.warn(yield_warning(*job_.encounter.yield_speed()));
  if (marked_ == 0) return 0;
  output_.warn(fmt::format("{} of {} values not as accurate as asked for (marked)", marked_, done_));
  return 1;
}

}  // namespace stoss::cli
