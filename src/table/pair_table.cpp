// In each cell ε = Σ c_mn u^m t^n, a cubic in the share t of its interval of x = ln v and one in the share u of that of
// s = (r − 1)/(r + 1). s is tanh(½ ln r): it changes its sign with the inverse of r and needs no logarithm.
#include "stoss/table/pair_table.hpp"

#include <algorithm>
#include <array>
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

numeric::Bins logarithms(const std::vector<double>& speeds) {
  std::vector<double> all;
  all.reserve(speeds.size());
  for (const double each : speeds) all.push_back(std::log(each));
  return numeric::Bins(std::move(all));
}

numeric::Bins differences(const std::vector<double>& ratios) {
  std::vector<double> all;
  all.reserve(ratios.size());
  for (const double each : ratios) all.push_back(place_of_ratio(each));
  return numeric::Bins(std::move(all));
}

using Cubic = std::array<double, 4>;

/// Coefficients of the powers of t = (x − x₀)/width of the cubic with these values and slopes at the ends.
Cubic cubic(double width, double begin, double end, double slope, double slope_at_end) {
  const double first = width * slope, last = width * slope_at_end;
  return {begin, first, 3.0 * (end - begin) - 2.0 * first - last, 2.0 * (begin - end) + first + last};
}

struct Cell {
  double x, per_x, s, per_s;                           // where it begins, and 1 over its widths
  std::array<std::array<double, 4>, 4> coefficient{};  // of u^m t^n
};

}  // namespace

struct PairTable::Data {
  PairValues values;
  numeric::Bins x, s;
  Beyond beyond;
  double first, last;  // of s
  std::vector<Node> nodes{};
  std::vector<double> errors{};
  std::vector<Cell> cells{};

  Data(PairValues given, Beyond outside)
      : values(std::move(given)),
        x(logarithms(values.speeds)),
        s(differences(values.ratios)),
        beyond(outside),
        first(s.x().front() - rounding_of_ratios),
        last(s.x().back() + rounding_of_ratios),
        nodes(values.restitution.size()) {
    set_nodes();
    set_errors();
    set_cells();
  }

  void set_nodes() {
    std::vector<double> all;
    for (const Estimate& each : values.restitution) all.push_back(each.value);
    using numeric::Slopes;
    const Slopes between_ratios = values.alike ? Slopes::mirrored : Slopes::parabolic;
    const numeric::CubicGrid grid({x.x(), {0.0}, s.x()}, {Slopes::monotone, Slopes::monotone, between_ratios}, all);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double* node = &grid.nodes()[4 * i];
      nodes[i] = {node[0], node[1], node[2], node[3]};
    }
  }

  void set_errors() {
    const std::size_t columns = values.ratios.size();
    for (std::size_t k = 0; k + 1 < values.speeds.size(); ++k) {
      for (std::size_t j = 0; j + 1 < columns; ++j) {
        const Estimate *here = &values.restitution[k * columns + j], *next = here + columns;
        const double greatest = std::max({here[0].error, here[1].error, next[0].error, next[1].error});
        errors.push_back(table::weight_between_places * greatest + values.interpolation_error[k * (columns - 1) + j]);
      }
    }
  }

  void set_cells() {
    const std::size_t columns = values.ratios.size();
    for (std::size_t k = 0; k + 1 < values.speeds.size(); ++k) {
      for (std::size_t j = 0; j + 1 < columns; ++j) {
        const double width = x.x()[k + 1] - x.x()[k], length = s.x()[j + 1] - s.x()[j];
        const Node *here = &nodes[k * columns + j], *next = here + columns;
        std::array<Cubic, 2> value{}, slope{};  // in x, at either ratio: ε and its derivative by s
        for (std::size_t c = 0; c < 2; ++c) {
          value[c] = cubic(width, here[c].value, next[c].value, here[c].by_speed, next[c].by_speed);
          slope[c] = cubic(width, here[c].by_ratio, next[c].by_ratio, here[c].by_both, next[c].by_both);
        }
        Cell cell{x.x()[k], 1.0 / width, s.x()[j], 1.0 / length};
        for (std::size_t n = 0; n < 4; ++n) {
          const Cubic row = cubic(length, value[0][n], value[1][n], slope[0][n], slope[1][n]);
          for (std::size_t m = 0; m < 4; ++m) cell.coefficient[m][n] = row[m];
        }
        cells.push_back(cell);
      }
    }
  }

  [[nodiscard]] std::size_t cell_of(double logarithm, double difference) const {
    return x.interval(logarithm) * (values.ratios.size() - 1) + s.interval(difference);
  }

  [[nodiscard]] double at(std::size_t index, double logarithm, double difference) const {
    const Cell& cell = cells[index];
    const double t = (logarithm - cell.x) * cell.per_x, u = (difference - cell.s) * cell.per_s;
    Cubic row;  // in t
    for (std::size_t n = 0; n < 4; ++n) {
      const auto& c = cell.coefficient;
      row[n] = ((c[3][n] * u + c[2][n]) * u + c[1][n]) * u + c[0][n];
    }
    return ((row[3] * t + row[2]) * t + row[1]) * t + row[0];
  }

  /// s of a ratio, of its inverse where that is the same pair.
  [[nodiscard]] double place(double ratio) const {
    const double difference = place_of_ratio(ratio);
    return values.alike ? std::abs(difference) : difference;
  }

  /// Whether both are in the range. A NaN is not.
  [[nodiscard]] bool holds(double speed, double difference) const {
    return speed >= values.speeds.front() && speed <= values.speeds.back() && difference >= first && difference <= last;
  }

  [[nodiscard]] double outside(double speed, double ratio) const {
    if (!std::isfinite(speed)) {
      throw InvalidInput::out_of_range("speed", shown(speed), "a finite speed of approach");
    }
    if (!(ratio > 0.0) || !std::isfinite(ratio)) {
      throw InvalidInput::out_of_range("ratio", shown(ratio), "a positive finite ratio of radii");
    }
    const double difference = place(ratio);
    if (beyond == Beyond::error) {
      const bool of_speed = !(speed >= values.speeds.front() && speed <= values.speeds.back());
      const std::vector<double>& range = of_speed ? values.speeds : values.ratios;
      throw InvalidInput::out_of_range(of_speed ? "speed" : "ratio", shown(of_speed ? speed : ratio),
                                       shown_least(range.front()) + " to " + shown_most(range.back()) +
                                           (values.alike && !of_speed ? " or inverse" : ""),
                                       "the range for which the table was made");
    }
    const double logarithm = std::clamp(std::log(speed), x.x().front(), x.x().back());
    const double nearest = std::clamp(difference, first, last);
    return at(cell_of(logarithm, nearest), logarithm, nearest);
  }
};

PairTable::PairTable(PairValues values, Beyond beyond) {
  require_values(values);
  require_beyond(beyond);
  data_ = std::make_shared<const Data>(std::move(values), beyond);
}

Estimate PairTable::operator()(double speed, double ratio) const {
  const double size = std::abs(speed), difference = data_->place(ratio);
  if (!(ratio > 0.0) || !data_->holds(size, difference)) {
    return {data_->outside(size, ratio), std::numeric_limits<double>::infinity()};
  }
  const double logarithm = std::log(size);
  const std::size_t cell = data_->cell_of(logarithm, difference);
  return {data_->at(cell, logarithm, difference), data_->errors[cell]};
}

double PairTable::value(double speed, double ratio) const {
  const double size = std::abs(speed), difference = data_->place(ratio);
  if (!(ratio > 0.0) || !data_->holds(size, difference)) return data_->outside(size, ratio);
  const double logarithm = std::log(size);
  return data_->at(data_->cell_of(logarithm, difference), logarithm, difference);
}

const PairValues& PairTable::values() const { return data_->values; }
Beyond PairTable::beyond() const { return data_->beyond; }
const std::vector<PairTable::Node>& PairTable::nodes() const { return data_->nodes; }
const std::vector<double>& PairTable::errors() const { return data_->errors; }
double PairTable::greatest_error() const { return *std::max_element(data_->errors.begin(), data_->errors.end()); }

}  // namespace stoss
