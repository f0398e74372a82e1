#include "stoss/table/adaptive_rule.hpp"

#include <functional>
#include <utility>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/adaptive_pairs.hpp"
#include "table/arguments.hpp"
#include "table/axes.hpp"
#include "table/rule/adaptive_rules.hpp"
#include "table/rule/computed_rules.hpp"

namespace stoss {
namespace {

void require_rule_options(const AxisRange& speeds, const RuleTableOptions& options) {
  require_speeds(speeds);
  require_options(options.error, options.most_values, options.threads, options.beyond);
  require("tolerance", options.tolerance, ranges::rule_tolerance, "maximum error of the sliding after the collision");
}

void require_friction(bool mixing, const AxisRange& speeds, const RuleTableOptions& options) {
  if (!mixing) {
    if (!options.friction) return;
    throw InvalidInput::out_of_range("friction", shown(*options.friction), "none",
                                     "one table of these bodies serves any friction");
  }
  if (!options.friction) {
    throw InvalidInput::missing(
        "friction", "above 0 to 5",
        "motion along the surface changes the restitution of these bodies, so a table is of one friction");
  }
  require("friction", *options.friction, {0.0, 5.0, false, true, "above 0 to 5"}, "coefficient of Coulomb's law");
  const double most = (1.0 - gross_slip) / (1.0 + gross_slip) / *options.friction;
  if (speeds.high > most) {
    throw InvalidInput::out_of_range("speed", "up to " + shown(speeds.high) + " c", "up to " + shown_most(most) + " c",
                                     "1/9 of c over the friction: beyond, nothing slides throughout below c");
  }
}

/// @param normal ε_n of a speed, and of a ratio, alone
template <typename Normal>
RuleTable made(const std::function<RefinableContact(double)>& contact, const TableRange& range,
               const RuleTableOptions& options, Normal normal) {
  require_friction(mixes(contact(range.ratios.high), options.poll), range.speeds, options);
  // Where bodies may stay, their restitution may refuse the error at once; else wide contacts refuse their speeds.
  const bool may_stay = contact(range.ratios.high).at(0, options.poll).keeps_displacement;
  TableValues of_normal = !options.friction && may_stay ? normal() : TableValues{};
  AdaptiveRules rules(contact, range, options);
  if (!options.friction && !may_stay) of_normal = normal();
  rules.refine();
  RuleValues values{options.friction ? rules.values(1) : std::move(of_normal), rules.values(0), options.friction};
  RuleTable table(std::move(values), options.beyond);
  const auto require_reached = [](const char* name, double reached, double allowed) {
    if (reached <= allowed) return;
    throw NotConverged("rule_table: the errors add up to " + rounded(reached) + " (allow a larger " + name + ")");
  };
  require_reached("error", table.greatest_restitution_error(), options.error);
  require_reached("tolerance", table.greatest_sliding_error(), options.tolerance);
  return table;
}

}  // namespace

RuleTable rule_table(const RefinableContact& contact, double slowest, double fastest, const RuleTableOptions& options) {
  const AxisRange speeds{slowest, fastest};
  require_rule_options(speeds, options);
  return made([&](double) { return contact; }, {speeds}, options,
              [&] {
                return restitution_function(contact, slowest, fastest,
                                            {.error = options.error, .threads = options.threads, .poll = options.poll})
                    .values();
              });
}

RuleTable rule_table(const Mixture& mixture, double slowest, double fastest, double smallest, double largest,
                     const RuleTableOptions& options) {
  const AxisRange speeds{slowest, fastest};
  require_rule_options(speeds, options);
  const AxisRange ratios = held_ratios(mixture.alike, {smallest, largest});
  return made(mixture.contact, {speeds, ratios, true, mixture.alike}, options, [&] {
    return pair_table(mixture, slowest, fastest, smallest, largest,
                      {.error = options.error, .threads = options.threads, .poll = options.poll})
        .values();
  });
}

}  // namespace stoss
