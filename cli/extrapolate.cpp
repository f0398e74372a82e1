// stoss restitution --method extrapolate: as the paper does it, by regressions over exponential walls.
#include "extrapolate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "csv.hpp"
#include "interrupt.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/extrapolation.hpp"
#include "tables.hpp"

namespace stoss::cli {
namespace {

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

Row make_row(const Job& job, std::size_t row, const ExtrapolatedRestitution& r) {
  Row made{.record = job.record(row, extrapolation_table(), r), .trouble = {}};
  made.details["impacts"] = to_json(soft_impact_table(), r.impacts);
  made.details["hard_wall"] = intercepts(r);
  return made;
}

ExtrapolatedRestitution nothing() {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {{none, none}, {none, none}, {}, {}, 0};
}

}  // namespace

std::string extrapolate_columns(const Job& job) { return csv_columns(job.record(0, extrapolation_table(), {})); }

void check_extrapolate(const Job& job) {
  constexpr double slowest = 1e-3, fastest = 0.5;
  for (const double speed : job.speeds) {
    if (speed >= slowest && speed <= fastest) continue;
    throw InvalidInput(
        fmt::format("speed: got {} c, allowed {} to {} c with --method extrapolate (converge takes "
                    "all speeds)",
                    speed, slowest, fastest));
  }
  for (const double poisson : job.poissons) (void)job.contact(poisson).at(0);
}

void extrapolate(const Job& job, Sweep& sweep, Report& report) {
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
    Row row = make_row(job, sweep.done(), result);
    if (!trouble.empty()) row.details["reason"] = trouble;
    row.trouble = std::move(trouble);
    sweep.add(row, report);
  }
}

}  // namespace stoss::cli
