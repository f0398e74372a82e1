#include "trajectory.hpp"

#include "interrupt.hpp"
#include "tables.hpp"

namespace stoss::cli {

void Trajectory::write(const Snapshot& now) {
  if (!report_) {
    catch_interrupts();  // before, there is nothing to keep
    report_.emplace(Output(path_, Output::Use::rows), Format::csv, provenance_);
  }
  if (interrupted() != 0) {
    report_->finish(false);
    throw Interrupted{};
  }
  Record record;
  add_quantities(record, snapshot_table(), now, units_);
  report_->add(record);
}

void Trajectory::finish() {
  if (report_) report_->finish();
}

}  // namespace stoss::cli
