// 1 − ε² is computed to an absolute error, from which that of ε follows: δε = δ(1 − ε²)/2ε. The first attempt is enough
// for most, the next are for small ε.
#include "table/computed_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "check.hpp"
#include "restitution/ordered_jobs.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss {
namespace {

/// Why a value is not as accurate as it is needed, in terms of the error of a table: nobody has given a tolerance.
std::string reason(const Restitution& found) {
  constexpr std::string_view of_tolerance = "did not reach the tolerance";
  if (found.reason.compare(0, of_tolerance.size(), of_tolerance) != 0) return found.reason;
  std::array<char, 32> error{};
  (void)std::snprintf(error.data(), error.size(), "%.2g", found.restitution.error);
  return std::string("its error stays at ") + error.data() + ", and the table needs less (allow a greater error)";
}

/// Of a body that stays its ε is known to this, at any cutoff.
void require_reachable(const Restitution& found, double error, double share, const std::string& place) {
  const double least = std::sqrt(found.finest.remaining);
  if (least <= share * error) return;
  std::array<char, 32> allowed{};
  constexpr double margin = 1.05;
  (void)std::snprintf(allowed.data(), allowed.size(), "%.2g", margin * least / share);
  throw NotConverged("restitution: at " + place + " the body stays, and its restitution is known to " +
                     shown(std::ceil(1e5 * least) / 1e5) + " only (allow an error from " + allowed.data() + ")");
}

Estimate computed(const Request& request, double whole, double share, const std::string& place, const Poll& poll) {
  const double error = share * whole;
  constexpr double least = 1e-9, no_tolerance = 1e-15;
  double absolute = 1.6 * error;
  while (absolute > least) {
    const Restitution found = best_restitution(*request.contact, request.speed,
                                               {.tolerance = no_tolerance, .absolute = absolute, .poll = poll});
    if (found.restitution.error <= error) return found.restitution;
    require_reachable(found, whole, share, place);
    if (!found.reason.empty()) throw NotConverged("restitution: at " + place + " " + reason(found));
    absolute *= 0.25;
  }
  throw NotConverged("restitution: at " + place + " it is so small that its error cannot be estimated");
}

}  // namespace

std::vector<Estimate> computed_values(const std::vector<Request>& requests, double error, double share, int threads,
                                      const Poll& poll, const std::function<std::string(std::size_t)>& place) {
  const auto job = [&](std::size_t i, const Poll& own) { return computed(requests[i], error, share, place(i), own); };
  std::vector<Estimate> results;
  const auto deliver = [&results](std::size_t, Estimate&& result) { results.push_back(result); };
  run_in_order<Estimate>(requests.size(), threads, job, deliver, poll);
  return results;
}

}  // namespace stoss
