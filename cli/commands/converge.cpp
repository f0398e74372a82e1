// stoss restitution --method converge: the cutoff is raised until the error is small enough.
#include <fmt/format.h>

#include <algorithm>

#include "commands/job.hpp"
#include "process/process.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss::cli {
namespace {

Fields<Restitution> restitution_fields(const Units& units) {
  return Fields<Restitution>(restitution_quantities(), units,
                             {{"restitution", {.width = 22, .with_error = true}},
                              {"lost_fraction", {.width = 25, .with_error = true, .mark = {{"converged", false}}}},
                              {"contact_time", {.width = 13, .si_width = 17}},
                              {"cutoff", {.in_si = false}}});
}

nlohmann::ordered_json details(const Restitution& r) {
  nlohmann::ordered_json object{{"runs", to_json(run_quantities(), r.runs)}};
  if (!r.runs.empty()) object["ledger"] = to_json(ledger_quantities(), std::vector{r.finest.energy}).front();
  if (!r.converged) object["reason"] = r.reason;
  return object;
}

std::string describe(const Attempt& attempt) {
  const Estimate& lost = attempt.lost_fraction;
  const std::string error = lost.error > 0.0 ? fmt::format("{:.1e}", lost.error / lost.value) : "unknown";
  return fmt::format("cutoff {:.0f}, relative error of 1-eps^2 so far {}", attempt.cutoff, error);
}

void check(const Job& job, const CurveOptions& asked) {
  validate(job.speeds, asked);
  const double slowest = *std::min_element(job.speeds.begin(), job.speeds.end());
  for (const double poisson : job.poissons) {
    const RefinableContact contact = job.contact(poisson);
    if (!asked.each.vibration.empty()) validate(contact, slowest, asked.each.vibration, heed_interrupts);
  }
}

/// The speeds of one Poisson's ratio that the run does not have yet.
void compute(const Job& job, RowRun& run, CurveOptions options, const Fields<Restitution>& fields) {
  const auto first = static_cast<std::ptrdiff_t>(run.done() % job.speeds.size());
  const std::vector<double> speeds(job.speeds.begin() + first, job.speeds.end());
  std::string state = "begins";
  options.each.poll = [&] {
    heed_interrupts();
    run.wait(state);
  };
  options.each.attempt_observer = [&state](const Attempt& attempt) { state = describe(attempt); };
  restitution_curve(job.contact(job.poisson(run.done())), speeds, options, [&](std::size_t, const Restitution& result) {
    heed_interrupts();
    run.add(job.row(run.done(), fields, result), details(result), result.converged ? "" : result.reason);
  });
}

}  // namespace

Method converging(const Job& job, const CurveOptions& asked) {
  check(job, asked);
  const Fields<Restitution> its = restitution_fields(job.units);
  return {job.plan(its.columns()), [&job, asked, its](RowRun& run) { compute(job, run, asked, its); }};
}

}  // namespace stoss::cli
