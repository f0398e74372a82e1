#include "table/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {

void require_beyond(Beyond beyond) {
  if (beyond == Beyond::law) {
    throw InvalidInput::out_of_range("beyond", "law", "error or clamp",
                                     "there is no law of slow impacts of unequal bodies");
  }
}

void require_options(double error, int most_values, int threads, Beyond beyond) {
  require("error", error, {1e-6, 0.1, true, true, "1e-6 to 0.1"}, "maximum error of the restitution");
  require("most_values", static_cast<std::int64_t>(most_values), 100, 10'000'000, "that are computed");
  require("threads", static_cast<std::int64_t>(threads), 0, 1024, "0 for as many as the machine has");
  require_beyond(beyond);
}

}  // namespace stoss

namespace stoss::table {
namespace {

double to_fifteen_digits(double value) {
  std::stringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::digits10);
  text << value;
  text >> value;
  return value;
}

}  // namespace

std::pair<double, double> speed_range(double slowest, double fastest, double scale) {
  require("scale", scale, {0.0, 1e100, false, true, "above 0 to 1e100"},
          "speed of the table over that of the function");
  const double low = slowest * scale, high = fastest * scale;
  return {std::min(low, to_fifteen_digits(low)), std::max(high, to_fifteen_digits(high))};
}

}  // namespace stoss::table
