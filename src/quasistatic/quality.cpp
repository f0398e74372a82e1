// (1 − ε²)Q = Σ b_k α^k, α = (2/π) atan(1/Q).
#include "quasistatic/quality.hpp"

#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "check.hpp"
#include "quasistatic/lossy_motion.hpp"

namespace stoss::quasistatic {

double loss_of_quality(double quality) {
  require("quality", quality, {0.5, 1e30, true, true, "0.5 to 1e30"}, "1/Q is the tangent of the angle of loss");
  constexpr std::array terms{2.40946699, -3.79729105, 1.49946465, 0.65837084, -1.18349334, 0.42733878};
  const double alpha = 2.0 / std::numbers::pi * std::atan(1.0 / quality);
  double sum = 0.0;
  for (std::size_t i = terms.size(); i-- > 0;) sum = sum * alpha + terms[i];
  return sum / quality;
}

double loss_number_of_quality(double quality) {
  const double asked = loss_of_quality(quality);
  const double first = asked / (2.0 * 1.153449);  // 1 − ε = c₁x
  constexpr double exact = 1e-9;
  if (asked < exact) return first;
  const auto excess = [asked](double number) {
    const double restitution = lossy_motion(LossyLaw::ting, number).restitution;
    return 1.0 - restitution * restitution - asked;
  };
  const double low = 0.9 * first, high = 30.0 * first;  // the loss grows less than x, at Q = 0.5 by a tenth
  constexpr int bits = 40;
  std::uintmax_t steps = 100;
  const auto ends = boost::math::tools::toms748_solve(excess, low, high, excess(low), excess(high),
                                                      boost::math::tools::eps_tolerance<double>(bits), steps);
  return 0.5 * (ends.first + ends.second);
}

}  // namespace stoss::quasistatic
