#include "stoss/table/adaptive_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "table/arguments.hpp"
#include "table/computed_values.hpp"
#include "table/nested_axis.hpp"

namespace stoss {
namespace {

constexpr double share_of_pairs = 0.2, share_of_grid = 0.375;  // 1.25 × the first + 2 × the second = 1
constexpr double knots_per_decade = 6.0;
constexpr std::size_t fewest_of_speeds = 6, fewest_of_ratios = 2;  // intervals

void require_rising(const char* name, double low, double high) {
  if (!(low < high)) {
    throw InvalidInput(std::string(name) + ": got " + shown(low) + " to " + shown(high) +
                       ", allowed a first value below the last");
  }
}

/// The range of ratios that the table holds: of bodies of one material those from 1 on.
std::pair<double, double> held(const Mixture& mixture, double smallest, double largest) {
  const Range range{1e-3, 1e3, true, true, "0.001 to 1000"};
  require("ratio", smallest, range, "radius of the second over that of the first");
  require("ratio", largest, range, "radius of the second over that of the first");
  require_rising("ratio", smallest, largest);
  if (!mixture.alike || smallest >= 1.0) return {smallest, largest};
  if (largest <= 1.0) return {1.0 / largest, 1.0 / smallest};
  return {1.0, std::max(largest, 1.0 / smallest)};
}

void require_options(double slowest, double fastest, const PairTableOptions& options) {
  require_speed(slowest);
  require_speed(fastest);
  require_rising("speed", slowest, fastest);
  require("error", options.error, {1e-6, 0.1, true, true, "1e-6 to 0.1"}, "maximum error of the restitution");
  require("most_values", static_cast<long>(options.most_values), 100, 10'000'000, "that are computed");
  require("threads", static_cast<long>(options.threads), 0, 1024, "0 for as many as the machine has");
  require_beyond(options.beyond);
}

std::size_t intervals(double low, double high, std::size_t fewest) {
  return std::max(fewest, static_cast<std::size_t>(std::ceil(knots_per_decade * std::log10(high / low))));
}

NestedAxis axis_of_speeds(double slowest, double fastest) {
  NestedAxis axis(Slopes::monotone);
  const std::size_t count = intervals(slowest, fastest, fewest_of_speeds);
  for (std::size_t i = 0; i <= count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    axis.add(std::log(slowest) + share * (std::log(fastest) - std::log(slowest)), 0);
  }
  return axis;
}

NestedAxis axis_of_ratios(double smallest, double largest, bool alike) {
  NestedAxis axis(alike ? Slopes::mirrored : Slopes::parabolic);
  const std::size_t count = intervals(smallest, largest, fewest_of_ratios);
  for (std::size_t i = 0; i <= count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    axis.add(std::tanh(0.5 * (std::log(smallest) + share * (std::log(largest) - std::log(smallest)))), 0);
  }
  return axis;
}

/// ε at all crossings of two axes, which grow.
class Grid {
 public:
  Grid(const Mixture& mixture, double slowest, double fastest, double smallest, double largest,
       const PairTableOptions& options)
      : speeds_(axis_of_speeds(slowest, fastest)),
        ratios_(axis_of_ratios(smallest, largest, mixture.alike)),
        mixture_(mixture),
        options_(options),
        ends_of_speeds_{slowest, fastest},
        ends_of_ratios_{smallest, largest} {
    compute();
  }

  /// Halves intervals until all are accurate.
  void refine() {
    const double enough = share_of_grid * options_.error;
    for (;;) {
      if (!speeds_.halve(missed(speeds_, columns()), enough) && !ratios_.halve(missed(ratios_, rows()), enough)) return;
      compute();
    }
  }

  [[nodiscard]] PairValues values() const {
    PairValues table;
    table.alike = mixture_.alike;
    for (std::size_t k = 0; k < speeds_.size(); ++k) table.speeds.push_back(speed(k));
    for (std::size_t j = 0; j < ratios_.size(); ++j) table.ratios.push_back(ratio(j));
    for (const auto& row : values_) {
      for (const auto& each : row.second) table.restitution.push_back(each.second);
    }
    std::vector<std::vector<double>> of_speeds, of_ratios;
    for (const auto& column : columns()) of_speeds.push_back(speeds_.worst_of_three(speeds_.missed(column)));
    for (const auto& row : rows()) of_ratios.push_back(ratios_.worst_of_three(ratios_.missed(row)));
    for (std::size_t k = 0; k + 1 < speeds_.size(); ++k) {
      for (std::size_t j = 0; j + 1 < ratios_.size(); ++j) {
        table.interpolation_error.push_back(std::max(of_speeds[j][k], of_speeds[j + 1][k]) +
                                            std::max(of_ratios[k][j], of_ratios[k + 1][j]));
      }
    }
    return table;
  }

 private:
  using Lists = std::vector<std::vector<double>>;

  /// Maximum distance in each interval over all lines along an axis.
  [[nodiscard]] static std::vector<double> missed(const NestedAxis& axis, const Lists& lines) {
    std::vector<double> greatest(axis.size() - 1);
    for (const std::vector<double>& line : lines) {
      const std::vector<double> own = axis.missed(line);
      for (std::size_t k = 0; k < own.size(); ++k) greatest[k] = std::max(greatest[k], own[k]);
    }
    return greatest;
  }

  [[nodiscard]] Lists rows() const {
    Lists lists;
    for (const auto& row : values_) {
      lists.emplace_back();
      for (const auto& each : row.second) lists.back().push_back(each.second.value);
    }
    return lists;
  }

  [[nodiscard]] Lists columns() const {
    Lists lists(ratios_.size());
    for (const std::vector<double>& row : rows()) {
      for (std::size_t j = 0; j < row.size(); ++j) lists[j].push_back(row[j]);
    }
    return lists;
  }

  /// The ends of the ranges are exact.
  [[nodiscard]] double speed(std::size_t k) const {
    if (k == 0) return ends_of_speeds_.first;
    return k + 1 == speeds_.size() ? ends_of_speeds_.second : std::exp(speeds_.x()[k]);
  }

  [[nodiscard]] double ratio(std::size_t j) const {
    if (j == 0) return ends_of_ratios_.first;
    const double s = ratios_.x()[j];
    return j + 1 == ratios_.size() ? ends_of_ratios_.second : (1.0 + s) / (1.0 - s);
  }

  /// Computes what is missing, ratio by ratio.
  void compute() {
    if (speeds_.size() * ratios_.size() > static_cast<std::size_t>(options_.most_values)) {
      throw NotConverged("pair_table: more than " + std::to_string(options_.most_values) +
                         " values are needed (allow a greater error, smaller ranges, or more values)");
    }
    std::vector<Request> requests;
    std::vector<std::pair<std::size_t, std::size_t>> places;
    for (std::size_t j = 0; j < ratios_.size(); ++j) {
      const double s = ratios_.x()[j];
      if (!contacts_.contains(s)) contacts_.emplace(s, mixture_.contact(ratio(j)));
      const RefinableContact& contact = contacts_.at(s);
      for (std::size_t k = 0; k < speeds_.size(); ++k) {
        if (values_[speeds_.x()[k]].contains(s)) continue;
        requests.push_back({&contact, speed(k)});
        places.emplace_back(k, j);
      }
    }
    const auto named = [&](std::size_t i) {
      return "speed " + shown(speed(places[i].first)) + " c and the ratio " + shown(ratio(places[i].second));
    };
    const std::vector<Estimate> found =
        computed_values(requests, share_of_pairs * options_.error, options_.threads, options_.poll, named);
    for (std::size_t i = 0; i < found.size(); ++i) {
      values_[speeds_.x()[places[i].first]][ratios_.x()[places[i].second]] = found[i];
    }
  }

  NestedAxis speeds_, ratios_;  ///< ln v, s
  const Mixture& mixture_;
  const PairTableOptions& options_;
  std::pair<double, double> ends_of_speeds_, ends_of_ratios_;
  std::map<double, RefinableContact> contacts_;          ///< by s
  std::map<double, std::map<double, Estimate>> values_;  ///< by ln v and s
};

}  // namespace

PairTable pair_table(const Mixture& mixture, double slowest, double fastest, double smallest, double largest,
                     const PairTableOptions& options) {
  require_options(slowest, fastest, options);
  const std::pair<double, double> range = held(mixture, smallest, largest);
  Grid grid(mixture, slowest, fastest, range.first, range.second, options);
  grid.refine();
  return PairTable(grid.values(), options.beyond);
}

}  // namespace stoss
