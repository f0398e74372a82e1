#include "stoss/table/rule_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "table/arguments.hpp"
#include "table/table.hpp"

namespace stoss {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

void require_rule(const RuleValues& values) {
  const TableValues &normal = values.restitution, &along = values.sliding;
  if (along.slips.size() < 2)
    throw InvalidInput::out_of_range("slips", "one place of sliding", "two or more, from -1 to 1");
  if (normal.speeds.front() != along.speeds.front() || normal.speeds.back() != along.speeds.back() ||
      normal.ratios.front() != along.ratios.front() || normal.ratios.back() != along.ratios.back() ||
      normal.alike != along.alike) {
    throw InvalidInput::out_of_range("speeds", "other ends of restitution than of sliding", "the same",
                                     "of ratios, too");
  }
  if (values.friction) require("friction", *values.friction, {0.0, 5.0, false, true, "above 0 to 5"}, "of the values");
}

}  // namespace

struct RuleTable::Data {
  RuleValues values;
  Beyond beyond;
  Table restitution, sliding;

  Data(RuleValues given, Beyond outside)
      : values(std::move(given)),
        beyond(outside),
        restitution("restitution", values.restitution),
        sliding("sliding", values.sliding) {
    require_rule(values);
  }

  [[nodiscard]] bool has(double friction) const {
    return values.friction ? friction == *values.friction : friction >= 0.0 && std::isfinite(friction);
  }
};

RuleTable::RuleTable(RuleValues values, Beyond beyond) {
  require_beyond(beyond);
  data_ = std::make_shared<const Data>(std::move(values), beyond);
}

Rule RuleTable::unchecked(double speed, double sliding, double friction, double ratio) const {
  const double v = std::abs(speed), s = std::abs(sliding), limit = friction * v, scale = s + limit;
  const Table& along = data_->sliding;
  if (!std::isfinite(v) || !std::isfinite(s) || !data_->has(friction) ||
      (along.is_mixture() && !(ratio > 0.0 && std::isfinite(ratio)))) {
    return {{nothing, nothing}, nothing, nothing};
  }
  const double p = along.is_mixture() ? along.place(ratio) : 0.0;
  const bool inside = along.is_mixture() ? along.holds(v, p) : along.holds(v);
  if (!inside && data_->beyond == Beyond::error) return {{nothing, infinity}, nothing, infinity};
  const double z = scale > 0.0 ? (s - limit) / scale : -1.0;
  const Estimate normal = data_->restitution.nearest(v, z, p), after = along.nearest(v, z, p);
  const double left = std::clamp(after.value * scale, -s, s);
  return {{std::clamp(normal.value, 0.0, 1.0), inside ? normal.error : infinity},
          std::signbit(sliding) ? -left : left,
          inside ? after.error : infinity};
}

Rule RuleTable::operator()(double speed, double sliding, double friction, double ratio) const {
  const Table& along = data_->sliding;
  const auto& own = data_->values.friction;
  if (!std::isfinite(sliding)) throw InvalidInput::out_of_range("sliding", shown(sliding), "a finite velocity");
  if (!data_->has(friction)) {
    throw InvalidInput::out_of_range("friction", shown(friction), own ? shown(*own) : "0 or more",
                                     own ? "for which the table was made" : "");
  }
  along.require_numbers(speed, ratio);
  if (data_->beyond == Beyond::error) along.require_inside(std::abs(speed), ratio);
  return unchecked(speed, sliding, friction, ratio);
}

const RuleValues& RuleTable::values() const { return data_->values; }
Beyond RuleTable::beyond() const { return data_->beyond; }
const std::vector<double>& RuleTable::restitution_nodes() const { return data_->restitution.nodes(); }
const std::vector<double>& RuleTable::sliding_nodes() const { return data_->sliding.nodes(); }
const std::vector<double>& RuleTable::restitution_errors() const { return data_->restitution.errors(); }
const std::vector<double>& RuleTable::sliding_errors() const { return data_->sliding.errors(); }
double RuleTable::greatest_restitution_error() const { return data_->restitution.greatest_error(); }
double RuleTable::greatest_sliding_error() const { return data_->sliding.greatest_error(); }

}  // namespace stoss
