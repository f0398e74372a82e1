#include "commands/trajectory.hpp"

#include "process/interrupt.hpp"
#include "stoss/impact/quantities.hpp"

namespace stoss::cli {

Trajectory::Trajectory(std::string path, Provenance provenance, const Units& units)
    : path_(std::move(path)),
      provenance_(std::move(provenance)),
      fields_(snapshot_quantities(), Units{.own = units.own}) {}

void Trajectory::write(const Snapshot& now) {
  if (!writer_) {
    catch_interrupts();  // before, there is nothing to keep
    writer_.emplace(Output(path_, Output::Use::rows), Format::csv, provenance_, fields_.columns());
  }
  if (interrupted() != 0) {
    writer_->finish(false);
    throw Interrupted{};
  }
  writer_->add(fields_.row(now));
}

void Trajectory::finish() {
  if (writer_) writer_->finish();
}

}  // namespace stoss::cli
