// Values of q, and where directions mix of ε_n, at places that an AdaptiveGrid asks for.
#include "table/rule/adaptive_rules.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "table/arguments.hpp"

namespace stoss {
namespace {

constexpr double probe = 0.5;           // |z| of the slips at which the ways to slide are compared
constexpr double least_left = 0.3;      // share of an error that must be left beside what they differ by
constexpr double margin_of_ways = 1.2;  // of that difference
constexpr double share_of_rules = 0.5;  // of what is left, with their weight between places; the rest for the middles

NestedAxis axis_of_slips() {
  NestedAxis axis(numeric::Slopes::parabolic);
  for (const double z : {-1.0, -probe, 0.0, probe, gross_slip, 1.0}) axis.add(z, 0);
  return axis;
}

}  // namespace

AdaptiveRules::AdaptiveRules(std::function<RefinableContact(double)> contact, const TableRange& range,
                             const RuleTableOptions& options)
    : grid_(range, axis_of_slips()), range_(range), contacts_(std::move(contact), range), options_(options) {
  set_budget();
}

void AdaptiveRules::refine() {
  const std::vector<double> enough =
      options_.friction ? std::vector{sliding_.grid, restitution_.grid} : std::vector{sliding_.grid};
  grid_.refine("rule_table", enough, options_.most_values, [this](const std::vector<Place>& open) { compute(open); });
}

TableValues AdaptiveRules::values(std::size_t quantity) const {
  TableValues made = grid_.table(quantity);
  std::size_t i = 0;
  for (const double x : grid_.axis(0).x()) {
    for (const double z : grid_.axis(1).x()) {
      for (const double p : grid_.axis(2).x()) {
        const bool known = quantity == 0 && std::abs(z) == 1.0;
        made.values[i++].error += known ? 0.0 : difference(x, p, quantity);
      }
    }
  }
  return made;
}

double AdaptiveRules::weight() const {
  return table::weight_between_places * (range_.is_mixture ? table::weight_between_places : 1.0);
}

double AdaptiveRules::difference(double v, double s, std::size_t quantity) const {
  double greatest = 0.0;
  for (const double z : {-probe, 0.0, probe}) greatest = std::max(greatest, grid_.at({v, z, s})[2 + quantity].value);
  return greatest;
}

std::vector<std::vector<RulePoint>> AdaptiveRules::points(const std::vector<Place>& lines,
                                                          const std::vector<std::vector<RuleSlip>>& slips) {
  std::vector<RuleRequest> requests;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    requests.push_back({&contacts_.at(lines[i][2]), range_.speeds.speed(lines[i][0]), slips[i]});
  }
  const auto place = [&](std::size_t i) { return range_.named(lines[i][0], lines[i][2]); };
  return computed_rules(requests, {options_.friction, sliding_.values, options_.tolerance, restitution_.values},
                        options_.threads, options_.poll, place);
}

AdaptiveRules::Budget AdaptiveRules::without(double error, double difference) const {
  const double left = error - margin_of_ways * weight() * difference;
  return {share_of_rules / weight() * left, (1.0 - share_of_rules) * left / static_cast<double>(grid_.dimensions())};
}

void AdaptiveRules::require_left(const char* option, double error, double difference) const {
  const double taken = margin_of_ways * weight() * difference;
  if (error - taken >= least_left * error) return;
  throw NotConverged("rule_table: at speed " + shown(range_.speeds.high) +
                     " c velocity and spin differ too much in their effect (allow a larger " + option + ", from " +
                     shown(std::ceil(1e4 * taken / (1.0 - least_left)) / 1e4) + ", or slower speeds)");
}

void AdaptiveRules::set_budget() {
  // First as if there were no difference; it is largest where the contact is.
  sliding_ = without(options_.tolerance, 0.0), restitution_ = without(options_.error, 0.0);
  const std::vector<double>&v = grid_.axis(0).x(), &s = grid_.axis(2).x();
  const std::vector<RuleSlip> slips{{-probe, true}, {0.0, true}, {probe, true}};
  double along = 0.0, normal = 0.0;
  std::vector<Place> ends{{v.back(), 0.0, s.front()}};
  if (range_.is_mixture) ends.push_back({v.back(), 0.0, s.back()});
  for (const auto& end : points(ends, std::vector(ends.size(), slips))) {
    for (const RulePoint& each : end) {
      along = std::max(along, each.sliding_difference);
      if (options_.friction) normal = std::max(normal, each.restitution_difference);
    }
  }
  require_left("tolerance", options_.tolerance, along);
  require_left("error", options_.error, normal);
  sliding_ = without(options_.tolerance, along), restitution_ = without(options_.error, normal);
}

void AdaptiveRules::compute(const std::vector<Place>& open) {
  std::vector<Place> lines;
  std::vector<std::vector<RuleSlip>> slips;
  for (const Place& place : open) {
    if (place[1] > gross_slip || (place[1] == -1.0 && !options_.friction)) continue;
    if (lines.empty() || lines.back()[0] != place[0] || lines.back()[2] != place[2]) {
      lines.push_back(place);
      slips.emplace_back();
    }
    slips.back().push_back({place[1], place[1] == 0.0 || std::abs(place[1]) == probe});
  }
  const std::vector<std::vector<RulePoint>> found = points(lines, slips);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = 0; k < slips[i].size(); ++k) {
      const RulePoint& point = found[i][k];
      const double z = slips[i][k].z;
      const Estimate sliding = z == -1.0 ? Estimate{} : point.sliding;  // nothing slides
      grid_.set({lines[i][0], z, lines[i][2]},
                {sliding, point.restitution, {point.sliding_difference, 0.0}, {point.restitution_difference, 0.0}});
    }
  }
  follow(open);
}

void AdaptiveRules::follow(const std::vector<Place>& open) {
  for (const Place& place : open) {
    if (place[1] == -1.0 && !options_.friction) grid_.set(place, AdaptiveGrid::Values(4));
    if (place[1] <= gross_slip) continue;
    AdaptiveGrid::Values values = grid_.at({place[0], gross_slip, place[2]});
    // 1 − q falls to 0 along a straight line.
    const double share = (1.0 - place[1]) / (1.0 - gross_slip);
    values[0] = {1.0 - share * (1.0 - values[0].value), share * values[0].error};
    grid_.set(place, std::move(values));
  }
}

}  // namespace stoss
