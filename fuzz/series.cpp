// A series has as many numbers as it says, between its ends and in their order.
#include <cmath>
#include <vector>

#include "oracle.hpp"
#include "stoss/encounter/series.hpp"

using namespace stoss;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  if (size > 256) return 0;
  // A million numbers of 70 digits take seconds: series as long as that are left to the tests.
  const auto last = text.rfind(':');
  if (last != std::string_view::npos) {
    bool is_long = false;
    (void)fuzz::reads([&] { is_long = parse_number("n", text.substr(last + 1)) > 100.0; });
    if (is_long) return 0;
  }
  std::vector<double> values;
  if (!fuzz::reads([&] { values = parse_series("series", text); })) return 0;
  fuzz::hold(!values.empty(), "there are numbers");
  for (const double value : values) fuzz::hold(std::isfinite(value), "all are finite");
  if (last == std::string_view::npos) return 0;
  fuzz::hold(values.size() == static_cast<std::size_t>(parse_integer("n", text.substr(last + 1))), "n of them");
  const bool rises = values.back() >= values.front();
  for (std::size_t i = 1; i < values.size(); ++i) {
    fuzz::hold(rises ? values[i] >= values[i - 1] : values[i] <= values[i - 1], "in the order of the ends");
  }
  return 0;
}
