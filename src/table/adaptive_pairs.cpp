#include "stoss/table/adaptive_pairs.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "table/adaptive_grid.hpp"
#include "table/arguments.hpp"
#include "table/axes.hpp"
#include "table/computed_values.hpp"

namespace stoss {
namespace {

constexpr double share_of_pairs = 0.2, share_of_grid = 0.375;  // 1.25 × the first + 2 × the second = 1

void require_options(double slowest, double fastest, const PairTableOptions& options) {
  require_speeds({slowest, fastest});
  require("error", options.error, {1e-6, 0.1, true, true, "1e-6 to 0.1"}, "maximum error of the restitution");
  require("most_values", static_cast<long>(options.most_values), 100, 10'000'000, "that are computed");
  require("threads", static_cast<long>(options.threads), 0, 1024, "0 for as many as the machine has");
  require_beyond(options.beyond);
}

/// ε at crossings of ln v and s, which grow.
class Pairs {
 public:
  Pairs(const Mixture& mixture, const AxisRange& speeds, const AxisRange& ratios, const PairTableOptions& options)
      : grid_({axis_of_speeds(speeds), one_place(), axis_of_ratios(ratios, mixture.alike)}),
        mixture_(mixture),
        options_(options),
        speeds_(speeds),
        ratios_(ratios) {
    compute();
  }

  /// Halves intervals until all are accurate.
  void refine() {
    while (grid_.halve({share_of_grid * options_.error})) compute();
  }

  [[nodiscard]] TableValues values() const {
    TableValues table{{}, {0.0}, {}, grid_.values(0), grid_.interpolation_errors(0), mixture_.alike};
    for (const double each : grid_.axis(0).x()) table.speeds.push_back(speeds_.speed(each));
    for (const double each : grid_.axis(2).x()) table.ratios.push_back(ratios_.ratio(each));
    return table;
  }

 private:
  /// Computes what is missing, ratio by ratio.
  void compute() {
    if (grid_.size() > static_cast<std::size_t>(options_.most_values)) {
      throw NotConverged("pair_table: more than " + std::to_string(options_.most_values) +
                         " values are needed (allow a greater error, smaller ranges, or more values)");
    }
    const std::vector<AdaptiveGrid::Place> places = grid_.open();
    std::vector<Request> requests;
    for (const auto& [logarithm, none, s] : places) {
      if (!contacts_.contains(s)) contacts_.emplace(s, mixture_.contact(ratios_.ratio(s)));
      requests.push_back({&contacts_.at(s), speeds_.speed(logarithm)});
    }
    const auto named = [&](std::size_t i) {
      return "speed " + rounded(speeds_.speed(places[i][0])) + " c and the ratio " +
             rounded(ratios_.ratio(places[i][2]));
    };
    const std::vector<Estimate> found =
        computed_values(requests, options_.error, share_of_pairs, options_.threads, options_.poll, named);
    for (std::size_t i = 0; i < found.size(); ++i) grid_.set(places[i], {found[i]});
  }

  AdaptiveGrid grid_;
  const Mixture& mixture_;
  const PairTableOptions& options_;
  AxisRange speeds_, ratios_;
  std::map<double, RefinableContact> contacts_;  ///< by s
};

}  // namespace

PairTable pair_table(const Mixture& mixture, double slowest, double fastest, double smallest, double largest,
                     const PairTableOptions& options) {
  require_options(slowest, fastest, options);
  Pairs pairs(mixture, {slowest, fastest}, held_ratios(mixture.alike, {smallest, largest}), options);
  pairs.refine();
  return PairTable(pairs.values(), options.beyond);
}

}  // namespace stoss
