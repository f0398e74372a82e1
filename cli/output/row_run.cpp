#include "output/row_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app.hpp"
#include "output/fields.hpp"
#include "process/process.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/quantities.hpp"

namespace stoss::cli {

RowRun::RowRun(RowPlan plan, const RowOptions& options)
    : plan_(std::move(plan)), options_(options), progress_(options.output, plan_.size) {}

Writer RowRun::open(const Provenance& provenance) {
  const OutputOptions& asked = options_.output;
  const bool file = !asked.path.empty() && asked.path != "-";
  if (options_.resume.empty() && !(file && asked.chosen_format() == Format::csv)) {
    return asked.writer(provenance, plan_.columns);
  }
  if (options_.resume.empty())
    return {Output(asked.path, Output::Use::rows), Format::csv, provenance, plan_.columns, true};
  Output earlier(options_.resume, Output::Use::resume);  // locked from before the first row is read
  const Earlier its = read_earlier(earlier, provenance, plan_.columns, [this](const Row& row) { take(row); });
  if (its.size > 0) return {std::move(earlier), its.size, its.checked};
  return {std::move(earlier), Format::csv, provenance, plan_.columns, true};
}

void RowRun::write(const Provenance& provenance, const std::function<void()>& compute) {
  catch_interrupts();
  writer_.emplace(open(provenance));
  writer_->finish_after(compute);
}

void RowRun::count(const Row& row) {
  const Value* value = find(plan_.columns, row, "restitution");
  if (has(plan_.columns, row, "converged", false) || std::isnan(number(*value))) ++marked_;
  if (has(plan_.columns, row, "stays", true)) stays_ = true;
  if (value && number(*value) > 0.0) least_ = std::min(least_, number(*value));
  const auto note = [&](const char* flag, const char* quantity, double& greatest) {
    if (has(plan_.columns, row, flag, true)) greatest = std::max(greatest, number(*find(plan_.columns, row, quantity)));
  };
  note("beyond_small_strain", "strain", strain_);
  note("beyond_small_turn", "turned", turned_);
  if (const Value* speed = find(plan_.columns, row, "speed")) {
    fastest_ = std::max(fastest_, number(*speed));
  }
  if (plan_.observer) plan_.observer(row);
  ++done_;
}

/// Takes note of a row of an earlier run. @throws InvalidInput unless it is the next one
void RowRun::take(const Row& row) {
  if (done_ == plan_.size) {
    throw InvalidInput::out_of_range("resume", fmt::format("a row {} in the file", done_ + 1), fmt::format("{}", done_),
                                     "mend it, or write another file");
  }
  const Row key = plan_.key(done_);
  const auto same = [](const Value& a, const Value& b) { return number(a) == number(b); };
  if (!std::equal(key.begin(), key.end(), row.begin(), same)) {
    const auto width = static_cast<std::ptrdiff_t>(key.size());
    const Columns columns(plan_.columns.begin(), plan_.columns.begin() + width);
    throw InvalidInput::out_of_range("resume",
                                     fmt::format("{} {} in row {} of the file", csv_columns(columns),
                                                 csv_row({row.begin(), row.begin() + width}), done_ + 1),
                                     fmt::format("{}", csv_row(key)), "mend it, or write another file");
  }
  count(row);
}

void RowRun::add(const Row& row, const nlohmann::ordered_json& details, const std::string& trouble) {
  progress_.hide();
  writer_->add(row, details);
  if (!trouble.empty()) options_.output.warn(fmt::format("{}: {}", plan_.name(done_), trouble));
  count(row);
  progress_.show(done_);
}

void RowRun::conclude() const {
  if (stays_) options_.output.warn(note_of_staying());
  if (plan_.encounter && plan_.encounter->against.kind == "plate") {
    if (const std::string note = note_of_a_plate(least_); !note.empty()) options_.output.warn(note);
  }
  if (strain_ > 0.0) options_.output.warn_of_strain(strain_);
  if (turned_ > 0.0) options_.output.warn_of_turning(turned_);
  if (plan_.encounter && fastest_ > 0.0) warn_of_materials(options_.output, *plan_.encounter, fastest_);
  if (marked_ == 0) return;
  options_.output.warn(fmt::format("{} of {} values not as accurate as asked for (marked)", marked_, done_));
  throw NotAsAsked{};
}

}  // namespace stoss::cli
