#include "tally_rows.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace validate {

std::string cell(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  std::string all = " ";
  all += text.data();
  return all += " |";
}

void write_tally(std::ostream& out, const char* bodies, const char* quantity, const Tally& all) {
  const auto percent = [&all](int part) { return cell("%.1f %%", 100.0 * part / all.points); };
  out << "| " << bodies << " | " << quantity << " | " << all.points << " |" << percent(all.within)
      << percent(all.strictly_within) << cell("%.2f", all.greatest)
      << (std::isfinite(all.padding) ? cell("%.1f", all.padding) : " – |") << ' ' << all.blurred << " |\n";
}

void write_answer(std::ostream& out, const Point& point, const Answer& answer, const char* format) {
  const stoss::Estimate &reference = *point.reference[lost_fraction], &value = answer.value[lost_fraction];
  const Deviation off = deviation(value, reference);
  out << cell(format, reference.value) << cell("%.1e", reference.error) << cell(format, value.value)
      << cell("%.1e", value.error) << cell(off.padding ? "%.2f" : "%.2f u", off.ratio) << cell("%.0f", answer.cutoff)
      << "\n";
}

}  // namespace validate
