#include "bodies/plate/sheet.hpp"

#include <algorithm>

namespace stoss::bodies::plate {

std::vector<Sheets> parts_of(const std::vector<Sheet>& plate) {
  if (!std::equal(plate.begin(), plate.end(), plate.rbegin())) return {{plate}};
  std::vector<Sheet> half(plate.begin(), plate.begin() + static_cast<std::ptrdiff_t>((plate.size() + 1) / 2));
  if (plate.size() % 2 == 1) half.back().thickness *= 0.5;
  return {{half, Floor::symmetric, 0.5}, {half, Floor::antisymmetric, 0.5}};
}

}  // namespace stoss::bodies::plate
