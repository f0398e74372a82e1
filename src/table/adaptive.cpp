#include "stoss/table/adaptive.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "table/adaptive_grid.hpp"
#include "table/computed_values.hpp"

namespace stoss {
namespace {

constexpr double share_of_values = 1.0 / 3.0, share_of_interpolation = 0.5;
constexpr double margin = 1.5;  // of values: one of twenty is beyond its error, and a function has many
// Of the error asked for: all middles may be met by chance where so little is at stake.
constexpr double least_share = 0.01;

void require_options(double slowest, double fastest, const FunctionOptions& options) {
  require_speed(slowest);
  require_speed(fastest);
  if (!(slowest < fastest)) {
    throw InvalidInput::out_of_range("range", shown(slowest) + " to " + shown(fastest),
                                     "a slowest speed below the fastest");
  }
  require("error", options.error, ranges::table_error, "maximum error of the restitution");
  require("most_speeds", static_cast<long>(options.most_speeds), 16, 100'000, "at which it is computed");
  require("threads", static_cast<long>(options.threads), 0, 1024, "0 for as many as the machine has");
}

}  // namespace

RestitutionFunction restitution_function(const RefinableContact& contact, double slowest, double fastest,
                                         const FunctionOptions& options) {
  const auto computed = [&](const std::vector<double>& speeds) {
    std::vector<Request> requests;
    requests.reserve(speeds.size());
    for (const double speed : speeds) requests.push_back({&contact, speed});
    const auto place = [&speeds](std::size_t i) { return "speed " + rounded(speeds[i]) + " c"; };
    return computed_values(requests, options.error, share_of_values, options.threads, options.poll, place);
  };
  return restitution_function(computed, slowest, fastest, options);
}

RestitutionFunction restitution_function(const ComputedRestitution& computed, double slowest, double fastest,
                                         const FunctionOptions& options) {
  require_options(slowest, fastest, options);
  const AxisRange range{slowest, fastest};
  AdaptiveGrid grid({range});
  grid.refine("restitution_function", {share_of_interpolation * options.error}, options.most_speeds,
              [&](const std::vector<AdaptiveGrid::Place>& open) {
                std::vector<double> speeds;
                speeds.reserve(open.size());
                for (const auto& place : open) speeds.push_back(range.speed(place[0]));
                const std::vector<Estimate> found = computed(speeds);
                for (std::size_t i = 0; i < open.size(); ++i) {
                  grid.set(open[i], {{found[i].value, margin * found[i].error}});
                }
              });
  TableValues values = grid.table(0);
  for (double& each : values.interpolation_error) each = std::max(each, least_share * options.error);
  return RestitutionFunction(std::move(values), options.beyond, options.law);
}

}  // namespace stoss
