// A number that is read is the double that the standard library finds too; text of it reads back as the same bits.
#include <charconv>
#include <cmath>

#include "oracle.hpp"
#include "stoss/encounter/series.hpp"

using namespace stoss;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  double value = 0.0;
  if (fuzz::reads([&] { value = parse_number("number", text); })) {
    const auto from = std::min(text.find_first_not_of(" +"), text.size());
    double other = 0.0;
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + text.size(), other);
    fuzz::hold(error == std::errc{} && value == other && std::signbit(value) == std::signbit(other),
               "the nearest double");
    fuzz::hold(text.find_first_not_of(' ', static_cast<std::size_t>(end - text.data())) == std::string_view::npos,
               "all of it is read");
  }
  int whole = 0;
  if (fuzz::reads([&] { whole = parse_integer("integer", text); })) fuzz::hold(whole == value, "the same number");
  return 0;
}
