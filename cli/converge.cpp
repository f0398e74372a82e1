// stoss restitution --method converge: the cutoff is raised until the error is small enough.
#include "converge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "csv.hpp"
#include "interrupt.hpp"
#include "stoss/restitution/curve.hpp"
#include "tables.hpp"

namespace stoss::cli {
namespace {

Row make_row(const Job& job, std::size_t row, const Restitution& r) {
  Row made{.record = job.record(row, restitution_table(), r), .trouble = r.converged ? "" : r.reason};
  made.details["runs"] = to_json(run_table(), r.runs);
  if (!r.runs.empty()) made.details["ledger"] = to_json(ledger_table(), r.finest.energy);
  if (!r.converged) made.details["reason"] = r.reason;
  return made;
}

std::string describe(const Attempt& attempt) {
  const Estimate& lost = attempt.lost_fraction;
  const std::string error = lost.error > 0.0 ? fmt::format("{:.1e}", lost.error / lost.value) : "unknown";
  return fmt::format("cutoff {:.0f}, relative error of 1-eps^2 so far {}", attempt.cutoff, error);
}

}  // namespace

std::string converge_columns(const Job& job) { return csv_columns(job.record(0, restitution_table(), {})); }

void check_converge(const Job& job, const CurveOptions& asked) {
  validate(job.speeds, asked);
  const double slowest = *std::min_element(job.speeds.begin(), job.speeds.end());
  for (const double poisson : job.poissons) {
    const RefinableContact contact = job.contact(poisson);
    if (!asked.each.vibration.empty()) validate(contact, slowest, asked.each.vibration, heed_interrupts);
  }
}

void converge(const Job& job, Sweep& sweep, Report& report, const CurveOptions& asked) {
  while (sweep.done() < job.size()) {
    const double poisson = job.poisson(sweep.done());
    const auto first = static_cast<std::ptrdiff_t>(sweep.done() % job.speeds.size());
    const std::vector<double> speeds(job.speeds.begin() + first, job.speeds.end());
    std::string state = "begins";
    const auto poll = [&] {
      heed_interrupts();
      sweep.wait(state);
    };
    const auto note = [&state](const Attempt& attempt) { state = describe(attempt); };
    CurveOptions options = asked;
    options.each.poll = poll;
    options.each.attempt_observer = note;
    restitution_curve(job.contact(poisson), speeds, options, [&](std::size_t, const Restitution& result) {
      heed_interrupts();
      sweep.add(make_row(job, sweep.done(), result), report);
    });
  }
}

}  // namespace stoss::cli
