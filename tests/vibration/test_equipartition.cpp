// Without damping the mean energy of translation before impacts tends to that of each mode.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/vibration/bounce.hpp"

namespace stoss {
namespace {

/// Student's t of 19 degrees of freedom that 99.9 % of all samples do not exceed in either direction.
constexpr std::size_t batches = 20;
constexpr double student = 3.883;

TEST(Equipartition, IsTheMeanOfALongSequence_long) {
  // Poincaré's section where the body touches has the invariant measure dQ dP at constant energy. In action and angle
  // it is uniform in the energies of the N modes, whose sum is at most the whole: translation has 1/(N + 1) of it in
  // the mean, and a share above x with the probability (1 − x)^N.
  const Contact at_wall = contact(disk(0.33, 3.2));
  const double modes = static_cast<double>(mode_count(at_wall));
  ASSERT_EQ(modes, 6.0);
  constexpr long discarded = 2000, count = 14000;
  std::vector<double> share;
  double first = 0.0;
  const BounceOptions options{
      .count = count, .flight_time = 9.7 * std::sqrt(10.0), .resolution = {.tail = Tail::quasistatic}};
  bounce(at_wall, 0.4, options, [&](const Bounce& now, const Impact&) {
    const double translation = now.before.translation / (now.before.translation + now.before.vibration);
    if (now.number <= 20) first += translation / 20.0;
    if (now.number > discarded) share.push_back(translation);
    EXPECT_NEAR(now.energy_error, 0.0, 0.03);
  });

  // Means of batches much longer than the memory of the sequence are independent.
  const auto check = [&](auto value, double expected, const char* what) {
    const std::size_t length = share.size() / batches;
    std::vector<double> means(batches, 0.0);
    for (std::size_t i = 0; i < length * batches; ++i) {
      means[i / length] += value(share[i]) / static_cast<double>(length);
    }
    double mean = 0.0, square = 0.0;
    for (const double each : means) mean += each / static_cast<double>(batches);
    for (const double each : means) square += (each - mean) * (each - mean);
    const double error = student * std::sqrt(square / static_cast<double>(batches * (batches - 1)));
    EXPECT_NEAR(mean, expected, error) << what;
    EXPECT_LT(error, 0.3 * expected) << what;  // narrow enough to tell it from other numbers of modes
    return error;
  };
  const double equal = 1.0 / (modes + 1.0);
  const double error = check([](double x) { return x; }, equal, "mean");
  EXPECT_GT(first, equal + 5.0 * error);  // it began far from that
  check([](double x) { return x > 0.1 ? 1.0 : 0.0; }, std::pow(0.9, modes), "above 0.1");
}

}  // namespace
}  // namespace stoss
