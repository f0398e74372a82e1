#include "stoss/table/adaptive.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "check.hpp"
#include "numeric/interpolation.hpp"
#include "stoss/errors.hpp"
#include "table/computed_values.hpp"

namespace stoss {
namespace {

constexpr double per_decade = 6.0;
constexpr std::size_t fewest_speeds = 7;
constexpr double share_of_values = 1.0 / 3.0, share_of_interpolation = 0.5;
constexpr double margin = 1.5;  // of values: one of twenty is beyond its error, and a function has many
constexpr double least_share =
    0.01;                       // of the error asked for: five middles may be met by chance where so little is at stake
constexpr double safety = 2.0;  // of interpolation: next to a kink half the spacing is hardly better than the whole

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

struct Knot {
  double speed;
  Estimate restitution;
};

/// An interval between knots that is to be halved.
struct Gap {
  double left, right;  ///< ln v of its ends
};

/// Computes ε at speeds and adds it to the knots, by ln v.
class Computation {
 public:
  Computation(const ComputedRestitution& computed, double slowest, double fastest, const FunctionOptions& options)
      : computed_(computed), slowest_(slowest), fastest_(fastest), options_(options) {}

  void add(const std::vector<double>& logarithms) {
    std::vector<double> speeds;
    speeds.reserve(logarithms.size());
    for (const double each : logarithms) speeds.push_back(speed_at(each));
    if (knots.size() + speeds.size() > static_cast<std::size_t>(options_.most_speeds)) {
      throw NotConverged("restitution_function: more than " + std::to_string(options_.most_speeds) +
                         " speeds are needed (allow a greater error, a smaller range, or more speeds)");
    }
    const std::vector<Estimate> values = computed_(speeds);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      knots[logarithms[i]] = {speeds[i], {values[i].value, margin * values[i].error}};
    }
  }

  std::map<double, Knot> knots;

 private:
  /// The ends of the range are exact.
  [[nodiscard]] double speed_at(double logarithm) const {
    if (logarithm <= std::log(slowest_)) return slowest_;
    return logarithm >= std::log(fastest_) ? fastest_ : std::exp(logarithm);
  }

  const ComputedRestitution& computed_;
  double slowest_, fastest_;
  const FunctionOptions& options_;
};

TableValues values(const std::map<double, Knot>& knots) {
  TableValues table;
  for (const auto& [logarithm, knot] : knots) {
    table.speeds.push_back(knot.speed);
    table.values.push_back(knot.restitution);
  }
  return table;
}

/// What it costs each interval that the cubic rises and falls only as its knots do: a bound of how far it is from the
/// cubic with the slopes of parabolas, which is of third order also where ε turns and at the ends.
std::vector<double> cost_of_monotony(const std::map<double, Knot>& knots) {
  constexpr double greatest = 4.0 / 27.0;  // of t(1 − t)²
  std::vector<double> x, y;
  for (const auto& [logarithm, knot] : knots) {
    x.push_back(logarithm);
    y.push_back(knot.restitution.value);
  }
  const std::vector<double> monotone = numeric::monotone_slopes(x, y), free = numeric::parabolic_slopes(x, y, false);
  const auto apart = [&](std::size_t k) { return std::abs(monotone[k] - free[k]); };
  std::vector<double> cost;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    cost.push_back(greatest * (x[k + 1] - x[k]) * (apart(k) + apart(k + 1)));
  }
  return cost;
}

/// What the interpolation may be off by in each interval. Its own middle may be met by chance, and both halves of an
/// interval have the same one: the worst of five counts, those of narrower ones as they would be at its width.
/// @param missed how far the middle was missed from which each interval came
std::vector<double> interpolation_errors(const std::map<double, Knot>& knots, const std::map<double, double>& missed) {
  std::vector<double> errors = cost_of_monotony(knots), x, own;
  for (const auto& each : knots) x.push_back(each.first);
  for (const auto& each : missed) own.push_back(each.second);
  const std::size_t last = own.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    const std::size_t first = std::min(std::max<std::size_t>(k, 2) - 2, last - 4);
    for (std::size_t i = first; i <= first + 4; ++i) {
      const double ratio = std::max(1.0, (x[k + 1] - x[k]) / (x[i + 1] - x[i]));
      errors[k] = std::max(errors[k], ratio * ratio * own[i]);
    }
  }
  return errors;
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
  const double begin = std::log(slowest), end = std::log(fastest);
  const auto steps =
      std::max(fewest_speeds, static_cast<std::size_t>(std::ceil(per_decade * (end - begin) / std::log(10.0))) + 1) - 1;
  std::vector<double> next;
  std::vector<Gap> open;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(steps);
    next.push_back(i == steps ? end : begin + share * (end - begin));
    if (i > 0) open.push_back({next[i - 1], next[i]});
  }
  Computation computation(computed, slowest, fastest, options);
  computation.add(next);
  const double enough = share_of_interpolation * options.error;
  std::map<double, double> missed;  // by the left end of each interval
  std::vector<double> interpolation;
  while (!open.empty()) {
    const RestitutionFunction before(values(computation.knots));
    next.clear();
    for (const Gap& gap : open) next.push_back(0.5 * (gap.left + gap.right));
    computation.add(next);
    std::vector<Gap> still;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const Knot& middle = computation.knots.at(next[i]);
      const double distance = safety * std::abs(before.value(middle.speed) - middle.restitution.value);
      for (const Gap& half : {Gap{open[i].left, next[i]}, Gap{next[i], open[i].right}}) {
        if (distance > enough) still.push_back(half);
        missed[half.left] = distance;
      }
    }
    open = std::move(still);
    if (!open.empty()) continue;
    interpolation = interpolation_errors(computation.knots, missed);
    for (double& each : interpolation) each = std::max(each, least_share * options.error);
    auto left = computation.knots.begin();
    for (const double each : interpolation) {
      const double begins = left->first, ends = (++left)->first;
      if (each > enough) open.push_back({begins, ends});
    }
  }
  TableValues table = values(computation.knots);
  table.interpolation_error = std::move(interpolation);
  return RestitutionFunction(std::move(table), options.beyond, options.law);
}

}  // namespace stoss
