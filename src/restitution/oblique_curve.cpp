// Many collision rules: cases at one speed together, several speeds at once.
#include "stoss/restitution/oblique_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "check.hpp"
#include "contact/along.hpp"
#include "contact/touch.hpp"
#include "impact/oblique/frame.hpp"
#include "restitution/oblique_errors.hpp"
#include "restitution/ordered_jobs.hpp"

namespace stoss {
namespace {

/// Where a job begins and ends in the list of cases.
using Span = std::pair<std::size_t, std::size_t>;

/// Of cases at one speed. @param most in one, so that a long list fits in memory and occupies all threads
std::vector<Span> jobs_of(const std::vector<ObliqueCase>& cases, std::size_t most) {
  std::vector<Span> jobs;
  for (std::size_t begin = 0, end = 0; begin < cases.size(); begin = end) {
    while (end < cases.size() && end - begin < most && cases[end].speed == cases[begin].speed) ++end;
    jobs.emplace_back(begin, end);
  }
  return jobs;
}

}  // namespace

double tangential_at(double angle, double speed) {
  require("angle", angle, {-90.0, 90.0, false, false, "-90 to 90, without its ends"}, "degrees from the normal");
  return speed * std::tan(angle * std::numbers::pi / 180.0);
}

void validate(const RefinableContact& contact, const std::vector<ObliqueCase>& cases,
              const ObliqueCurveOptions& options) {
  require_tolerance(options.each);
  require("threads", static_cast<long>(options.threads), 0, 1024, "0 for as many as the machine has");
  if (cases.empty()) return;
  const Contact& probe = contact.at(0, options.each.poll);
  bool rough = false;
  for (const ObliqueCase& each : cases) {
    require_speed(each.speed);
    ObliqueFrame(probe, each.speed, {}).require(each.before);
    rough = rough || each.before.friction > 0.0;
  }
  if (rough) (void)contacts_along(probe, options.each.poll);
  if (!probe.unbounded) (void)contact.highest_whole_level();  // refuses bodies that are too unequal
  if (options.each.vibration.empty()) return;
  const auto slower = [](const ObliqueCase& a, const ObliqueCase& b) { return a.speed < b.speed; };
  validate(contact, std::min_element(cases.begin(), cases.end(), slower)->speed, options.each.vibration,
           options.each.poll);
}

void oblique_curve(const RefinableContact& contact, const std::vector<ObliqueCase>& cases,
                   const ObliqueCurveOptions& options, const ObliqueObserver& observer) {
  validate(contact, cases, options);
  if (cases.empty()) return;
  constexpr std::size_t most = 32;
  const std::vector<Span> jobs = jobs_of(cases, touch(contact.at(0, options.each.poll)).circle ? most : 1);
  using Results = std::vector<ObliqueRestitution>;
  const auto job = [&](std::size_t k, const Poll& heed) {
    const auto [begin, end] = jobs[k];
    ObliqueOptions of_each = options.each;
    of_each.poll = heed;
    std::vector<Obliquity> before;
    for (std::size_t i = begin; i < end; ++i) before.push_back(cases[i].before);
    return oblique_restitution(contact, cases[begin].speed, before, of_each);
  };
  const auto deliver = [&](std::size_t k, Results&& results) {
    for (std::size_t i = 0; i < results.size(); ++i) observer(jobs[k].first + i, results[i]);
  };
  run_in_order<Results>(jobs.size(), options.threads, job, deliver, options.each.poll);
}

std::vector<ObliqueRestitution> oblique_curve(const RefinableContact& contact, const std::vector<ObliqueCase>& cases,
                                              const ObliqueCurveOptions& options) {
  std::vector<ObliqueRestitution> results;
  results.reserve(cases.size());
  oblique_curve(contact, cases, options,
                [&](std::size_t, const ObliqueRestitution& result) { results.push_back(result); });
  return results;
}

}  // namespace stoss
