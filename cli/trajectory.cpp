#include "trajectory.hpp"

#include "interrupt.hpp"

namespace stoss::cli {

void Trajectory::write(const Snapshot& now) {
  if (!report_) {
    report_.emplace(Output(path_), Format::csv, provenance_);
    catch_interrupts();  // before, there is nothing to keep
  }
  if (interrupted() != 0) {
    report_->finish(false);
    throw Interrupted{};
  }
  report_->add({{"time", "R/c", now.time},
                {"center", "R", now.center},
                {"velocity", "c", now.velocity},
                {"force", "piRE", now.force},
                {"translation", "", now.translation},
                {"vibration", "", now.vibration},
                {"stored", "", now.stored},
                {"unresolved", "", now.unresolved},
                {"contact_half_width", "R", now.contact_half_width}});
}

void Trajectory::finish() {
  if (report_) report_->finish();
}

}  // namespace stoss::cli
