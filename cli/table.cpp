#include "table.hpp"

#include "estimate.hpp"

namespace stoss::cli {

void add_value(Record& record, const std::string& name, const std::string& unit, const Value& value,
               const double* error, int width, const std::string& shown) {
  if (error == nullptr) {
    record.push_back({name, unit, value, width, shown});
  } else {
    add_estimate(record, name, unit, {std::get<double>(value), *error}, width, shown);
  }
}

Value scaled(const Value& value, double scale) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? Value(*number * scale) : value;
}

std::string shown_with_error(const Value& value, double error, const std::string& mark) {
  return with_error(std::get<double>(value), error) + mark;
}

}  // namespace stoss::cli
