// stoss restitution --method extrapolate: as the paper does it, by regressions over exponential walls.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "commands/job.hpp"
#include "process/process.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/extrapolation.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss::cli {
namespace {

Fields<ExtrapolatedRestitution> extrapolation_fields(const Units& units) {
  return Fields<ExtrapolatedRestitution>(extrapolation_quantities(), units,
                                         {{"restitution", {.width = 22, .with_error = true}},
                                          {"lost_fraction", {.width = 24, .with_error = true}},
                                          {"impacts", {.width = 9}}});
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

nlohmann::ordered_json details(const ExtrapolatedRestitution& r, const std::string& trouble) {
  nlohmann::ordered_json object{{"impacts", to_json(soft_impact_quantities(), r.impacts)},
                                {"hard_wall", intercepts(r)}};
  if (!trouble.empty()) object["reason"] = trouble;
  return object;
}

void check(const Job& job) {
  constexpr double slowest = 1e-3, fastest = 0.5;
  for (const double speed : job.speeds) {
    if (speed >= slowest && speed <= fastest) continue;
    throw InvalidInput(
        fmt::format("speed: got {} c, allowed {} to {} c with --method extrapolate (converge takes all speeds)", speed,
                    slowest, fastest));
  }
  for (const double poisson : job.poissons) (void)job.contact(poisson).at(0);
}

/// The next row.
void compute(const Job& job, RowRun& run, const Fields<ExtrapolatedRestitution>& fields) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  ExtrapolatedRestitution result{{none, none}, {none, none}, {}, {}, 0};
  std::string trouble;
  const auto poll = [&run] {
    heed_interrupts();
    run.wait("extrapolates");
  };
  try {
    result = extrapolated_restitution(job.poisson(run.done()), job.speed(run.done()),
                                      {.cutoffs = {}, .hardnesses = {}, .poll = poll});
  } catch (const NotConverged& error) {
    trouble = error.what();
  }
  run.add(job.row(run.done(), fields, result), details(result, trouble), trouble);
}

}  // namespace

Method extrapolating(const Job& job) {
  check(job);
  const Fields<ExtrapolatedRestitution> its = extrapolation_fields(job.units);
  return {job.plan(its.columns()), [&job, its](RowRun& run) { compute(job, run, its); }};
}

}  // namespace stoss::cli
