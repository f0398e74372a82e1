#include "sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "csv.hpp"
#include "stoss/errors.hpp"
#include "text.hpp"
#include "yield.hpp"

namespace stoss::cli {
namespace {

bool has(const Cells& cells, const std::string& column, const std::string& value) {
  const auto found = cells.find(column);
  return found != cells.end() && found->second == value;
}

}  // namespace

Sweep::Sweep(Rows rows, const OutputArguments& output)
    : rows_(std::move(rows)), output_(output), progress_(output, rows_.size) {
  for (const std::string& column : split(rows_.columns, ',')) names_.push_back(column.substr(0, column.find('[')));
}

void Sweep::count(const std::vector<std::string>& row) {
  Cells cells;
  for (std::size_t i = 0; i < names_.size(); ++i) cells[names_[i]] = row[i];
  if (has(cells, "converged", "false") || has(cells, "restitution", "nan")) ++marked_;
  if (has(cells, "beyond_small_strain", "true")) beyond_small_strain_ = true;
  if (has(cells, "beyond_yield", "true")) beyond_yield_ = true;
  if (rows_.observer) rows_.observer(cells);
  ++done_;
}

void Sweep::take(const std::vector<std::string>& cells) {
  if (done_ == rows_.size) {
    throw InvalidInput(
        fmt::format("resume: got a row {} in the file, allowed {} (mend it, or write another file)", done_ + 1, done_));
  }
  const Record key = rows_.key(done_);
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
  if (!row.trouble.empty()) output_.warn(fmt::format("{}: {}", rows_.name(done_), row.trouble));
  count(split(csv_row(row.record), ','));
  progress_.show(done_);
}

int Sweep::conclude() const {
  if (beyond_small_strain_) {
    output_.warn("speed above 0.5 c or compression above 0.5 R: linear elasticity has lost its meaning there");
  }
  if (beyond_yield_) output_.warn(yield_warning(*rows_.yield_speed));
  if (marked_ == 0) return 0;
  output_.warn(fmt::format("{} of {} values not as accurate as asked for (marked)", marked_, done_));
  return 1;
}

}  // namespace stoss::cli
