// ε_n and q = s′/(|s| + μ v) on grids of ln v, z and (r − 1)/(r + 1).
#include "stoss/table/rule_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "check.hpp"
#include "numeric/interpolation.hpp"
#include "stoss/errors.hpp"
#include "table/arguments.hpp"
#include "table/axes.hpp"

namespace stoss {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A grid with the errors of its cells.
struct GridWithErrors {
  numeric::CubicGrid cubic;
  std::vector<double> errors{};

  GridWithErrors(const RuleGrid& grid, bool alike) : cubic(made(grid, alike)) {
    const double weight = (grid.slips.size() > 1 ? table::weight_between_places : 1.0) *
                          (grid.ratios.size() > 1 ? table::weight_between_places : 1.0);
    const std::size_t slips = grid.slips.size(), ratios = grid.ratios.size();
    const auto greatest = [&](std::size_t i, std::size_t j, std::size_t k) {
      double error = 0.0;
      for (const std::size_t a : {i, i + 1}) {
        for (std::size_t b = j; b < std::min(j + 2, slips); ++b) {
          for (std::size_t c = k; c < std::min(k + 2, ratios); ++c) {
            error = std::max(error, grid.values[(a * slips + b) * ratios + c].error);
          }
        }
      }
      return error;
    };
    for (std::size_t i = 0; i < cubic.intervals(0); ++i) {
      for (std::size_t j = 0; j < cubic.intervals(1); ++j) {
        for (std::size_t k = 0; k < cubic.intervals(2); ++k) {
          errors.push_back(weight * greatest(i, j, k) + grid.interpolation_error[errors.size()]);
        }
      }
    }
  }

  [[nodiscard]] Estimate operator()(const numeric::CubicGrid::Place& at) const {
    const auto within = [&](std::size_t a) {
      return std::clamp(at[a], cubic.places()[a].front(), cubic.places()[a].back());
    };
    const auto known = [&](const numeric::CubicGrid::Found& found) {
      return Estimate{found.value, errors[found.cell]};
    };
    const bool slides = cubic.places()[1].size() > 1, mixes = cubic.places()[2].size() > 1;
    if (slides && mixes) return known(cubic.at<3>({within(0), within(1), within(2)}));
    if (slides) return known(cubic.at<2>({within(0), within(1)}));
    if (mixes) return known(cubic.at<2>({within(0), within(2)}));
    return known(cubic.at<1>({within(0)}));
  }

 private:
  static numeric::CubicGrid made(const RuleGrid& grid, bool alike) {
    using numeric::Slopes;
    numeric::CubicGrid::Places places{{{}, grid.slips, {}}};
    for (const double each : grid.speeds) places[0].push_back(std::log(each));
    for (const double each : grid.ratios) places[2].push_back(place_of_ratio(each));
    std::vector<double> values;
    for (const Estimate& each : grid.values) values.push_back(each.value);
    return {
        std::move(places), {Slopes::monotone, Slopes::parabolic, alike ? Slopes::mirrored : Slopes::parabolic}, values};
  }
};

}  // namespace

struct RuleTable::Data {
  RuleValues values;
  Beyond beyond;
  GridWithErrors restitution, sliding;

  Data(RuleValues given, Beyond outside)
      : values(std::move(given)),
        beyond(outside),
        restitution(values.restitution, values.alike),
        sliding(values.sliding, values.alike) {}

  [[nodiscard]] bool is_mixture() const { return values.sliding.ratios.size() > 1; }

  [[nodiscard]] double place(double ratio) const {
    const double s = place_of_ratio(ratio);
    return values.alike ? std::abs(s) : s;
  }

  [[nodiscard]] bool holds_speed(double speed) const {
    return speed >= values.sliding.speeds.front() && speed <= values.sliding.speeds.back();
  }

  [[nodiscard]] bool holds_ratio(double ratio) const {
    const std::vector<double>& ratios = values.sliding.ratios;
    return !is_mixture() || (place(ratio) >= place_of_ratio(ratios.front()) - rounding_of_ratios &&
                             place(ratio) <= place_of_ratio(ratios.back()) + rounding_of_ratios);
  }

  [[nodiscard]] bool has(double friction) const {
    return values.friction ? friction == *values.friction : friction >= 0.0 && std::isfinite(friction);
  }
};

RuleTable::RuleTable(RuleValues values, Beyond beyond) {
  require_values(values);
  require_beyond(beyond);
  data_ = std::make_shared<const Data>(std::move(values), beyond);
}

Rule RuleTable::unchecked(double speed, double sliding, double friction, double ratio) const {
  const double v = std::abs(speed), s = std::abs(sliding);
  const Rule none{{nothing, nothing}, nothing, nothing};
  if (!std::isfinite(v) || !std::isfinite(s) || !data_->has(friction)) return none;
  if (data_->is_mixture() && !(ratio > 0.0 && std::isfinite(ratio))) return none;
  const bool inside = data_->holds_speed(v) && data_->holds_ratio(ratio);
  if (!inside && data_->beyond == Beyond::error) return {{nothing, infinity}, nothing, infinity};
  const double limit = friction * v, scale = s + limit;
  const double z = scale > 0.0 ? (s - limit) / scale : -1.0;
  const double slowest = data_->values.sliding.speeds.front();
  const numeric::CubicGrid::Place at{std::log(std::max(v, slowest)), z,
                                     data_->is_mixture() ? data_->place(ratio) : 0.0};
  const Estimate normal = data_->restitution(at), along = data_->sliding(at);
  const double after = std::clamp(along.value * scale, -s, s);
  return {{std::clamp(normal.value, 0.0, 1.0), inside ? normal.error : infinity},
          std::signbit(sliding) ? -after : after,
          inside ? along.error : infinity};
}

Rule RuleTable::operator()(double speed, double sliding, double friction, double ratio) const {
  const auto refuse = [](const char* name, double got, const std::string& allowed) {
    return InvalidInput::out_of_range(std::string(name), shown(got), allowed);
  };
  if (!std::isfinite(speed)) throw refuse("speed", speed, "a finite speed of approach");
  if (!std::isfinite(sliding)) throw refuse("sliding", sliding, "a finite velocity");
  const auto& own = data_->values.friction;
  if (!data_->has(friction)) {
    throw refuse("friction", friction, own ? shown(*own) + " (for which the table was made)" : "0 or more");
  }
  if (data_->is_mixture() && !(ratio > 0.0 && std::isfinite(ratio))) {
    throw refuse("ratio", ratio, "a positive finite ratio of radii");
  }
  const auto outside = [&](const char* name, double got, const std::vector<double>& range, const char* inverse) {
    return refuse(name, got,
                  shown_least(range.front()) + " to " + shown_most(range.back()) + inverse +
                      " (the range for which the table was made)");
  };
  const RuleGrid& grid = data_->values.sliding;
  if (data_->beyond == Beyond::error && !data_->holds_speed(std::abs(speed))) {
    throw outside("speed", speed, grid.speeds, "");
  }
  if (data_->beyond == Beyond::error && !data_->holds_ratio(ratio)) {
    throw outside("ratio", ratio, grid.ratios, data_->values.alike ? " or inverse" : "");
  }
  return unchecked(speed, sliding, friction, ratio);
}

const RuleValues& RuleTable::values() const { return data_->values; }
Beyond RuleTable::beyond() const { return data_->beyond; }
const std::vector<double>& RuleTable::restitution_nodes() const { return data_->restitution.cubic.nodes(); }
const std::vector<double>& RuleTable::sliding_nodes() const { return data_->sliding.cubic.nodes(); }
const std::vector<double>& RuleTable::restitution_errors() const { return data_->restitution.errors; }
const std::vector<double>& RuleTable::sliding_errors() const { return data_->sliding.errors; }

double RuleTable::greatest_restitution_error() const {
  return *std::max_element(restitution_errors().begin(), restitution_errors().end());
}

double RuleTable::greatest_sliding_error() const {
  return *std::max_element(sliding_errors().begin(), sliding_errors().end());
}

}  // namespace stoss
