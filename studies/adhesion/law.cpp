#include "law.hpp"

#include <cmath>
#include <numbers>

namespace adhesion_study {

Law exponential_law(double work, double range, double ratio) {
  const double pressure = work / (range * (1.0 - ratio)), hard = ratio * range;
  return [=](double gap) -> Response {
    const double push = pressure * std::exp(-gap / hard), pull = pressure * std::exp(-gap / range);
    return {push - pull, -push / hard + pull / range, push * hard - pull * range};
  };
}

Law lennard_jones(double work, double distance) {
  const double pressure = 8.0 * work / (3.0 * distance);
  return [=](double gap) -> Response {
    const double z = std::max(gap / distance + 1.0, 0.05), pull = std::pow(z, -3), push = pull * pull * pull;
    return {pressure * (push - pull), pressure / distance * (3.0 * pull - 9.0 * push) / z,
            pressure * distance * z * (push / 8.0 - pull / 2.0)};
  };
}

Law asperities(double pressure, double range) {
  return [=](double gap) -> Response {
    const double push = pressure * std::exp(-gap / range);
    return {push, -push / range, push * range};
  };
}

double distance_of_pull(double work, double pull) { return 16.0 * work / (9.0 * std::numbers::sqrt3 * pull); }

double range_of(double tabor, double work, double modulus, double ratio) {
  const double distance = std::cbrt(work * work / (modulus * modulus)) / tabor;
  const double pull = 16.0 * work / (9.0 * std::numbers::sqrt3 * distance);
  return work / pull * std::pow(ratio, ratio / (1.0 - ratio));
}

}  // namespace adhesion_study
