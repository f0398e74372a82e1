#include "bodies/field_arguments.hpp"

#include <limits>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {

void require_finite(std::string_view name, std::span<const double> numbers, std::string_view hint) {
  constexpr double largest = std::numeric_limits<double>::max();
  for (const double number : numbers) require(name, number, {-largest, largest, true, true, "finite numbers"}, hint);
}

void require_length(const std::string& name, std::size_t length, std::size_t wanted, const std::string& hint) {
  if (length == wanted) return;
  throw InvalidInput(name + ": got " + std::to_string(length) + " values, allowed " + std::to_string(wanted) + " (" +
                     hint + ")");
}

}  // namespace stoss
