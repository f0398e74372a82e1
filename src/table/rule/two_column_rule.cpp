// Rows as far apart as a chord in s/μv stays near the rule.
#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "stoss/table/two_column.hpp"
#include "table/rule/adaptive_rules.hpp"

namespace stoss {

std::string two_column(const RuleTable& rule, double speed, double error) {
  constexpr double least = 1.01;  // of the error of the rule, to leave something for the chords
  constexpr int points = 32;      // at which a chord is looked at
  if (rule.values().sliding.ratios.size() > 1) {
    throw InvalidInput::conflict("ratio", "a mixture of sizes cannot be written as two columns",
                                 "give one pair of bodies");
  }
  const double allowed = least * rule.greatest_sliding_error();
  if (!(error >= allowed) || !std::isfinite(error)) {
    throw InvalidInput::out_of_range("error", shown(error), shown(allowed) + " or more",
                                     "1.01 of the maximum error of the rule");
  }
  const double friction = rule.values().friction.value_or(1.0), limit = friction * speed;
  const auto after = [&](double w) { return rule(speed, w * limit, friction).sliding_after / limit; };
  const double left = error - rule.greatest_sliding_error();
  const auto near = [&](double from, double to) {
    const double low = after(from), slope = (after(to) - low) / (to - from);
    for (int i = 1; i < points; ++i) {
      const double w = from + (to - from) * i / points;
      if (std::abs(low + slope * (w - from) - after(w)) > left * (1.0 + w)) return false;
    }
    return true;
  };
  const double last = (1.0 + gross_slip) / (1.0 - gross_slip);
  std::string text = "0 0\n";
  const auto add = [&](double w) { text += shown(w) + " " + shown(after(w)) + "\n"; };
  for (double from = 0.0; from < last; add(from)) {
    double reached = from, beyond = last;
    if (near(from, last)) reached = last;
    for (int i = 0; i < 40 && reached < last; ++i) {
      const double middle = 0.5 * (reached + beyond);
      (near(from, middle) ? reached : beyond) = middle;
    }
    from = reached;
  }
  add(2.0 * last);
  return text;
}

}  // namespace stoss
