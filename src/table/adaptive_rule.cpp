// q on a grid of ln v, z and the ratio of radii; with directions that mix, ε_n on the same one.
#include "stoss/table/adaptive_rule.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/adaptive_pairs.hpp"
#include "table/adaptive_grid.hpp"
#include "table/arguments.hpp"
#include "table/axes.hpp"
#include "table/computed_rules.hpp"

namespace stoss {
namespace {

constexpr double gross = 0.8;  // z of w = s/μv = 9, where all slides throughout: nothing sticks beyond (1 + ε)·7/2
constexpr double probe = 0.5;  // |z| of the slips at which the ways to slide are compared
constexpr double least_left = 0.3;      // share of an error that must be left beside what the ways to slide differ by
constexpr double margin_of_ways = 1.2;  // of that difference
constexpr double share_of_rules = 0.5;  // of what is left, with their weight between places; the rest for the middles

/// Parts of an error.
struct Budget {
  double values, grid;  ///< of each value, of the middles along each axis
};

/// What speeds, slips and ratios a table is of.
struct Ranges {
  AxisRange speeds, ratios;
  bool is_mixture, alike;

  [[nodiscard]] std::size_t axes() const { return is_mixture ? 3 : 2; }

  /// What the errors of values count in those of the table.
  [[nodiscard]] double weight() const {
    return table::weight_between_places * (is_mixture ? table::weight_between_places : 1.0);
  }
};

NestedAxis axis_of_slips() {
  NestedAxis axis(numeric::Slopes::parabolic);
  for (const double z : {-1.0, -probe, 0.0, probe, gross, 1.0}) axis.add(z, 0);
  return axis;
}

/// The rule at crossings of ln v, z and s, which grow.
class Rules {
 public:
  Rules(std::function<RefinableContact(double)> contact, const Ranges& ranges, const RuleTableOptions& options)
      : grid_({axis_of_speeds(ranges.speeds), axis_of_slips(),
               ranges.is_mixture ? axis_of_ratios(ranges.ratios, ranges.alike) : one_place()}),
        contact_(std::move(contact)),
        ranges_(ranges),
        options_(options) {
    set_budget();
  }

  void refine() {
    compute();
    const std::vector<double> enough =
        options_.friction ? std::vector{sliding_.grid, restitution_.grid} : std::vector{sliding_.grid};
    while (grid_.halve(enough)) compute();
  }

  /// A quantity of the grid with what the ways to slide differ by. @param quantity 0: q, 1: ε_n
  [[nodiscard]] RuleGrid values(std::size_t quantity) const {
    RuleGrid made{{}, grid_.axis(1).x(), {}, grid_.values(quantity), grid_.interpolation_errors(quantity)};
    for (const double each : grid_.axis(0).x()) made.speeds.push_back(ranges_.speeds.speed(each));
    for (const double each : grid_.axis(2).x()) made.ratios.push_back(ratio(each));
    std::size_t i = 0;
    for (const double v : grid_.axis(0).x()) {
      for (const double z : grid_.axis(1).x()) {
        for (const double s : grid_.axis(2).x()) {
          const bool known = quantity == 0 && std::abs(z) == 1.0;
          made.values[i++].error += known ? 0.0 : difference(v, s, quantity);
        }
      }
    }
    return made;
  }

 private:
  using Place = AdaptiveGrid::Place;

  [[nodiscard]] double ratio(double s) const { return ranges_.is_mixture ? ranges_.ratios.ratio(s) : 1.0; }

  /// Of a quantity at a speed and a ratio, what the ways to slide differ by.
  [[nodiscard]] double difference(double v, double s, std::size_t quantity) const {
    double greatest = 0.0;
    for (const double z : {-probe, 0.0, probe}) greatest = std::max(greatest, grid_.at({v, z, s})[2 + quantity].value);
    return greatest;
  }

  const RefinableContact& contact(double s) {
    if (!contacts_.contains(s)) contacts_.emplace(s, contact_(ratio(s)));
    return contacts_.at(s);
  }

  [[nodiscard]] std::string named(double speed, double s) const {
    return "speed " + shown(speed) + " c" + (ranges_.is_mixture ? " and the ratio " + shown(ratio(s)) : "");
  }

  [[nodiscard]] std::vector<std::vector<RulePoint>> points(const std::vector<Place>& lines,
                                                           const std::vector<std::vector<RuleSlip>>& slips) {
    std::vector<RuleRequest> requests;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      requests.push_back({&contact(lines[i][2]), ranges_.speeds.speed(lines[i][0]), slips[i]});
    }
    const auto place = [&](std::size_t i) { return named(requests[i].speed, lines[i][2]); };
    return computed_rules(requests, {options_.friction, sliding_.values, restitution_.values}, options_.threads,
                          options_.poll, place);
  }

  /// What is left of both errors beside what the ways to slide differ by where the contact is largest.
  void set_budget() {
    const auto without = [&](double error, double difference) -> Budget {
      const double left = error - margin_of_ways * ranges_.weight() * difference;
      return {share_of_rules / ranges_.weight() * std::max(left, least_left * error),
              (1.0 - share_of_rules) * left / static_cast<double>(ranges_.axes())};
    };
    sliding_ = without(options_.tolerance, 0.0), restitution_ = without(options_.error, 0.0);
    const std::vector<double>&v = grid_.axis(0).x(), &s = grid_.axis(2).x();
    const std::vector<Place> ends{{v.back(), 0.0, s.front()}, {v.back(), 0.0, s.back()}};
    const std::vector<RuleSlip> slips{{-probe, true}, {0.0, true}, {probe, true}};
    double along = 0.0, normal = 0.0;
    for (const auto& end : points(ends, {slips, slips})) {
      for (const RulePoint& each : end) {
        along = std::max(along, each.sliding_difference), normal = std::max(normal, each.restitution_difference);
      }
    }
    sliding_ = without(options_.tolerance, along);
    restitution_ = without(options_.error, options_.friction ? normal : 0.0);
    const auto require_left = [&](const char* name, const char* what, double error, const Budget& budget) {
      if (budget.grid * static_cast<double>(ranges_.axes()) >= (1.0 - share_of_rules) * least_left * error) return;
      const double needed = margin_of_ways * ranges_.weight() * (name[0] == 't' ? along : normal) / (1.0 - least_left);
      throw NotConverged("rule_table: at " + named(ranges_.speeds.high, s.back()) +
                         " velocity and spin of the same sliding differ in " + what + " (allow a " + name + " of " +
                         shown(std::ceil(1e4 * needed) * 1e-4) + ", or slower speeds)");
    };
    require_left("tolerance", "what becomes of it", options_.tolerance, sliding_);
    require_left("error", "the restitution", options_.error, restitution_);
  }

  /// Computes what is missing; what all slides to follows from where it begins to.
  void compute() {
    if (grid_.size() > static_cast<std::size_t>(options_.most_values)) {
      throw NotConverged("rule_table: more than " + std::to_string(options_.most_values) +
                         " values are needed (allow greater errors, smaller ranges, or more values)");
    }
    std::vector<Place> lines;
    std::vector<std::vector<RuleSlip>> slips;
    const std::vector<Place> open = grid_.open();
    for (const Place& place : open) {
      if (place[1] > gross || (place[1] == -1.0 && !options_.friction)) continue;
      if (lines.empty() || lines.back()[0] != place[0] || lines.back()[2] != place[2]) {
        lines.push_back(place);
        slips.emplace_back();
      }
      slips.back().push_back({place[1], place[1] == 0.0 || std::abs(place[1]) == probe});
    }
    const std::vector<std::vector<RulePoint>> found = points(lines, slips);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (std::size_t k = 0; k < slips[i].size(); ++k) {
        const auto& [restitution, sliding, restitution_difference, sliding_difference] = found[i][k];
        const double z = slips[i][k].z;
        grid_.set({lines[i][0], z, lines[i][2]}, {z == -1.0 ? Estimate{0.0, 0.0} : sliding,
                                                  restitution,
                                                  {sliding_difference, 0.0},
                                                  {restitution_difference, 0.0}});
      }
    }
    for (const Place& place : open) {
      if (place[1] == -1.0 && !options_.friction) grid_.set(place, AdaptiveGrid::Values(4));
      if (place[1] <= gross) continue;
      AdaptiveGrid::Values values = grid_.at({place[0], gross, place[2]});
      // 1 − q falls to 0 along a straight line.
      const double share = (1.0 - place[1]) / (1.0 - gross);
      values[0] = {1.0 - share * (1.0 - values[0].value), share * values[0].error};
      grid_.set(place, std::move(values));
    }
  }

  AdaptiveGrid grid_;  ///< of q, of ε_n, and of what the ways to slide differ by in either
  std::function<RefinableContact(double)> contact_;
  Ranges ranges_;
  const RuleTableOptions& options_;
  Budget sliding_{}, restitution_{};
  std::map<double, RefinableContact> contacts_{};  ///< by s
};

void require_options(const AxisRange& speeds, const RuleTableOptions& options) {
  require_speeds(speeds);
  require("error", options.error, {1e-6, 0.1, true, true, "1e-6 to 0.1"}, "maximum error of the restitution");
  require("tolerance", options.tolerance, {1e-4, 0.5, true, true, "1e-4 to 0.5"},
          "maximum error of the sliding after the collision");
  require("most_values", static_cast<long>(options.most_values), 100, 10'000'000, "that are computed");
  require("threads", static_cast<long>(options.threads), 0, 1024, "0 for as many as the machine has");
  require_beyond(options.beyond);
}

void require_friction(bool mixing, const AxisRange& speeds, const RuleTableOptions& options) {
  if (!mixing) {
    if (!options.friction) return;
    throw InvalidInput("friction: got " + shown(*options.friction) +
                       ", allowed none (one table of these bodies serves any friction)");
  }
  if (!options.friction) {
    throw InvalidInput(
        "friction: got none, allowed above 0 to 5 (motion along the surface changes the restitution of these bodies, "
        "so a table is of one friction)");
  }
  require("friction", *options.friction, {0.0, 5.0, false, true, "above 0 to 5"}, "coefficient of Coulomb's law");
  const double most = (1.0 - gross) / (1.0 + gross) / *options.friction;
  if (speeds.high > most) {
    throw InvalidInput("speed: got up to " + shown(speeds.high) + " c, allowed up to " + shown(most) +
                       " c (1/9 of c over the friction: beyond, nothing slides throughout below c)");
  }
}

RuleGrid grid_of(const RestitutionFunction& function) {
  RuleGrid made;
  made.interpolation_error = function.interpolation_errors();
  for (const auto& [speed, restitution] : function.knots()) {
    made.speeds.push_back(speed);
    made.values.push_back(restitution);
  }
  return made;
}

RuleGrid grid_of(const PairTable& pairs) {
  const PairValues& values = pairs.values();
  return {values.speeds, {0.0}, values.ratios, values.restitution, values.interpolation_error};
}

/// @param normal ε_n of a speed, and of a ratio, alone
template <typename Normal>
RuleTable made(const std::function<RefinableContact(double)>& contact, const Ranges& ranges,
               const RuleTableOptions& options, Normal normal) {
  require_friction(mixes(contact(ranges.ratios.high), options.poll), ranges.speeds, options);
  Rules rules(contact, ranges, options);
  rules.refine();
  RuleValues values{options.friction ? rules.values(1) : normal(), rules.values(0), ranges.alike, options.friction};
  return RuleTable(std::move(values), options.beyond);
}

}  // namespace

RuleTable rule_table(const RefinableContact& contact, double slowest, double fastest, const RuleTableOptions& options) {
  const AxisRange speeds{slowest, fastest};
  require_options(speeds, options);
  return made(
      [&](double) { return contact; }, {speeds, {1.0, 1.0}, false, false}, options,
      [&] {
        return grid_of(restitution_function(
            contact, slowest, fastest, {.error = options.error, .threads = options.threads, .poll = options.poll}));
      });
}

RuleTable rule_table(const Mixture& mixture, double slowest, double fastest, double smallest, double largest,
                     const RuleTableOptions& options) {
  const AxisRange speeds{slowest, fastest};
  require_options(speeds, options);
  const AxisRange ratios = held_ratios(mixture.alike, {smallest, largest});
  return made(mixture.contact, {speeds, ratios, true, mixture.alike}, options, [&] {
    return grid_of(pair_table(mixture, slowest, fastest, smallest, largest,
                              {.error = options.error, .threads = options.threads, .poll = options.poll}));
  });
}

}  // namespace stoss
