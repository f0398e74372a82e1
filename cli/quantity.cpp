#include "quantity.hpp"

#include "estimate.hpp"

namespace stoss::cli {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace

void add_reading(Record& record, const std::string& name, const std::string& unit, const Reading& reading, int width,
                 const std::string& shown) {
  const auto add = [&](const auto& value) { record.push_back({name, unit, value, width, shown}); };
  const auto estimate = [&](const Estimate& value) { add_estimate(record, name, unit, value, width, shown); };
  std::visit(Overloaded{add, estimate}, reading);
}

std::string shown_with_error(const Reading& reading, const std::string& mark) {
  const auto& estimate = std::get<Estimate>(reading);
  return with_error(estimate.value, estimate.error) + mark;
}

Reading scaled(const Reading& reading, double scale) {
  const auto number = [scale](double value) -> Reading { return value * scale; };
  const auto estimate = [scale](const Estimate& e) -> Reading { return Estimate{e.value * scale, e.error * scale}; };
  const auto other = [](const auto& value) -> Reading { return value; };
  return std::visit(Overloaded{number, estimate, other}, reading);
}

}  // namespace stoss::cli
