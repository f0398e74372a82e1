// stoss restitution --method extrapolate: as the paper does it, by regressions over exponential walls.
#include "extrapolate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "csv.hpp"
#include "estimate.hpp"
#include "interrupt.hpp"
#include "numbers.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/extrapolation.hpp"

namespace stoss::cli {
namespace {

Record make_record(const ExtrapolatedRestitution& r, double poisson, double speed, const std::optional<Scales>& si) {
  Record record{{"poisson", "", poisson, si ? 0 : 8}, {"speed", "c", speed, si ? 0 : 12}};
  if (si) record.push_back({"speed_si", "m/s", speed * si->speed, 12});
  const auto add = [&record](const std::string& key, const Estimate& estimate, int width) {
    add_estimate(record, key, "", estimate, width, with_error(estimate.value, estimate.error));
  };
  add("restitution", r.restitution, 22);
  add("lost_fraction", r.lost_fraction, 24);
  record.push_back({"impacts", "", static_cast<long>(r.impacts.size()), 9});
  record.push_back({"steps", "", r.steps});
  return record;
}

/// 1 − ε² for α → ∞ with the modes that each is for; the impacts are sorted by cutoff.
nlohmann::ordered_json intercepts(const ExtrapolatedRestitution& r) {
  auto list = nlohmann::ordered_json::array();
  auto impact = r.impacts.begin();
  for (const Estimate& hard : r.hard_wall) {
    const double cutoff = impact->cutoff;
    list.push_back({{"cutoff", cutoff},
                    {"modes", impact->modes},
                    {"lost_fraction", hard.value},
                    {"lost_fraction_error", hard.error}});
    impact = std::find_if(impact, r.impacts.end(), [cutoff](const SoftImpact& i) { return i.cutoff != cutoff; });
    if (impact == r.impacts.end()) break;
  }
  return list;
}

Row make_row(const ExtrapolatedRestitution& r, double poisson, double speed, const std::optional<Scales>& si) {
  Row row{.record = make_record(r, poisson, speed, si), .trouble = {}};
  auto impacts = nlohmann::ordered_json::array();
  for (const SoftImpact& impact : r.impacts) {
    impacts.push_back({{"cutoff", impact.cutoff},
                       {"modes", impact.modes},
                       {"hardness", impact.hardness},
                       {"lost_fraction", impact.lost_fraction},
                       {"steps", impact.steps}});
  }
  row.details["impacts"] = std::move(impacts);
  row.details["hard_wall"] = intercepts(r);
  return row;
}

ExtrapolatedRestitution nothing() {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {{none, none}, {none, none}, {}, {}, 0};
}

}  // namespace

std::string extrapolate_columns(const Job& job) { return csv_columns(make_record({}, 0.0, 0.0, job.si)); }

void check_extrapolate(const Job& job) {
  constexpr double slowest = 1e-3, fastest = 0.5;
  for (const double speed : job.speeds) {
    if (speed >= slowest && speed <= fastest) continue;
    throw InvalidInput(
        fmt::format("speed: got {} c, allowed {} to {} c with --method extrapolate (converge takes "
                    "all speeds)",
                    speed, slowest, fastest));
  }
  for (const double poisson : job.poissons) (void)RefinableContact(disk(poisson)).at(0);
}

void extrapolate(Sweep& sweep, Report& report) {
  const Job& job = sweep.job();
  while (sweep.done() < job.size()) {
    const double poisson = job.poisson(sweep.done());
    const double speed = job.speed(sweep.done());
    std::string trouble;
    ExtrapolatedRestitution result = nothing();
    try {
      result = extrapolated_restitution(poisson, speed, {.cutoffs = {}, .hardnesses = {}, .poll = heed_interrupts});
    } catch (const NotConverged& error) {
      trouble = error.what();
    }
    Row row = make_row(result, poisson, speed, job.si);
    if (!trouble.empty()) row.details["reason"] = trouble;
    row.trouble = std::move(trouble);
    sweep.add(row, report);
  }
}

}  // namespace stoss::cli
