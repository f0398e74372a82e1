// stoss restitution --method converge: the cutoff is raised until the error is small enough.
#include "converge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "csv.hpp"
#include "estimate.hpp"
#include "interrupt.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss::cli {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Record make_record(const Restitution& r, double poisson, double speed, const std::optional<Scales>& si) {
  const Impact& finest = r.finest;
  const bool ran = !r.runs.empty();
  Record record{{"poisson", "", poisson, si ? 0 : 8}, {"speed", "c", speed, si ? 0 : 12}};
  const auto add = [&record](Entry entry) { record.push_back(std::move(entry)); };
  const auto estimate = [&record](const std::string& key, const std::string& unit, const Estimate& estimated, int width,
                                  const std::string& shown = {}) {
    add_estimate(record, key, unit, estimated, width, shown);
  };
  const auto scaled = [](const Estimate& e, double scale) { return Estimate{e.value * scale, e.error * scale}; };
  if (si) add({"speed_si", "m/s", speed * si->speed, 12});
  estimate("restitution", "", r.restitution, 22, with_error(r.restitution.value, r.restitution.error));
  const std::string mark = r.converged ? "  " : " !";
  estimate("lost_fraction", "", r.lost_fraction, 25, with_error(r.lost_fraction.value, r.lost_fraction.error) + mark);
  estimate("contact_time", "R/c", r.contact_time, si ? 0 : 13);
  estimate("max_compression", "R", r.max_compression, 0);
  estimate("max_force", "piRE", r.max_force, 0);
  add({"cutoff", "c/R", ran ? finest.cutoff : none});
  add({"modes", "", static_cast<long>(finest.energy.modes.size())});
  add({"runs", "", static_cast<long>(r.runs.size())});
  add({"steps", "", r.steps});
  add({"energy_error", "", ran ? finest.energy_error : none});
  add({"converged", "", r.converged});
  add({"beyond_small_strain", "", finest.beyond_small_strain});
  if (si) {
    estimate("contact_time_si", "s", scaled(r.contact_time, si->time), 17);
    estimate("max_force_si", "N/m", scaled(r.max_force, si->force), 0);
    estimate("max_compression_si", "m", scaled(r.max_compression, si->length), 0);
  }
  return record;
}

nlohmann::ordered_json to_json(const std::vector<Run>& runs) {
  auto list = nlohmann::ordered_json::array();
  for (const Run& run : runs) {
    list.push_back({{"cutoff", run.cutoff},
                    {"step", run.step},
                    {"nodes", run.nodes},
                    {"lost_fraction", run.lost_fraction},
                    {"contact_time", run.contact_time},
                    {"max_force", run.max_force},
                    {"max_compression", run.max_compression},
                    {"energy_error", run.energy_error},
                    {"steps", run.steps}});
  }
  return list;
}

Row make_row(const Restitution& r, double poisson, double speed, const std::optional<Scales>& si) {
  Row row{.record = make_record(r, poisson, speed, si), .trouble = r.converged ? "" : r.reason};
  row.details["runs"] = to_json(r.runs);
  if (!r.runs.empty()) {
    const EnergyLedger& ledger = r.finest.energy;
    row.details["ledger"] = {{"translation", ledger.translation},
                             {"vibration", ledger.vibration},
                             {"unresolved", ledger.unresolved},
                             {"stored", ledger.stored}};
  }
  if (!r.converged) row.details["reason"] = r.reason;
  return row;
}

std::string describe(const Attempt& attempt) {
  const Estimate& lost = attempt.lost_fraction;
  const std::string error = lost.error > 0.0 ? fmt::format("{:.1e}", lost.error / lost.value) : "unknown";
  return fmt::format("cutoff {:.0f}, relative error of 1-eps^2 so far {}", attempt.cutoff, error);
}

}  // namespace

std::string converge_columns(const Job& job) { return csv_columns(make_record({}, 0.0, 0.0, job.si)); }

void check_converge(const Job& job, double tolerance, int threads) {
  validate(job.speeds, {tolerance, threads});
  for (const double poisson : job.poissons) (void)disk(poisson);
}

void converge(Sweep& sweep, Report& report, double tolerance, int threads) {
  const Job& job = sweep.job();
  while (sweep.done() < job.size()) {
    const double poisson = job.poisson(sweep.done());
    const auto first = static_cast<std::ptrdiff_t>(sweep.done() % job.speeds.size());
    const std::vector<double> speeds(job.speeds.begin() + first, job.speeds.end());
    std::string state = "begins";
    const auto poll = [&] {
      heed_interrupts();
      sweep.wait(state);
    };
    const auto note = [&state](std::size_t, const Attempt& attempt) { state = describe(attempt); };
    restitution_curve(RefinableContact(disk(poisson)), speeds, {tolerance, threads, poll, note},
                      [&](std::size_t i, const Restitution& result) {
                        heed_interrupts();
                        sweep.add(make_row(result, poisson, speeds[i], job.si), report);
                      });
  }
}

}  // namespace stoss::cli
