#include "digits.hpp"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace stoss {

std::string shown(double value) {
  if (std::isnan(value)) return "nan";  // without the sign that some processors give it
  std::string text;
  for (int digits = 10; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    std::ostringstream writer;
    writer.imbue(std::locale::classic());
    writer.precision(digits);
    writer << value;
    text = writer.str();
    std::istringstream reader(text);
    reader.imbue(std::locale::classic());
    double read = 0.0;
    if (reader >> read && read == value) break;
  }
  return text;
}

}  // namespace stoss
