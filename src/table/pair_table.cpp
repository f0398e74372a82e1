#include "stoss/table/pair_table.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "stoss/errors.hpp"
#include "table/arguments.hpp"
#include "table/table.hpp"

namespace stoss {

struct PairTable::Data {
  Table table;
  Beyond beyond;

  [[nodiscard]] Estimate outside(double speed, double ratio) const {
    table.require_numbers(speed, ratio);
    if (beyond == Beyond::error) table.require_inside(speed, ratio);
    return {table.nearest(speed, 0.0, table.place(ratio)).value, std::numeric_limits<double>::infinity()};
  }
};

PairTable::PairTable(TableValues values, Beyond beyond) {
  require_beyond(beyond);
  data_ = std::make_shared<const Data>(Data{Table("restitution", std::move(values)), beyond});
  const auto& [speeds, slips, ratios, given, interpolation, alike] = data_->table.values();
  if (ratios.size() < 3) throw InvalidInput::out_of_range("ratios", std::to_string(ratios.size()), "3 or more");
  if (slips.size() > 1) throw InvalidInput::conflict("slips", "several, which only a rule has");
}

Estimate PairTable::operator()(double speed, double ratio) const {
  const Table& table = data_->table;
  const double size = std::abs(speed), p = table.place(ratio);
  if (!(ratio > 0.0) || !table.holds(size, p)) return data_->outside(size, ratio);
  return table.known(table.at<2>({std::log(size), p}));
}

double PairTable::value(double speed, double ratio) const {
  const Table& table = data_->table;
  const double size = std::abs(speed), p = table.place(ratio);
  if (!(ratio > 0.0) || !table.holds(size, p)) return data_->outside(size, ratio).value;
  return table.at<2>({std::log(size), p}).value;
}

const TableValues& PairTable::values() const { return data_->table.values(); }
Beyond PairTable::beyond() const { return data_->beyond; }
const std::vector<double>& PairTable::nodes() const { return data_->table.nodes(); }
const std::vector<double>& PairTable::errors() const { return data_->table.errors(); }
double PairTable::greatest_error() const { return data_->table.greatest_error(); }

}  // namespace stoss
