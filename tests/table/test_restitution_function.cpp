// A function between computed values: the cubic of Boost, its knots, what lies beyond its range.
#include "stoss/table/restitution_function.hpp"

#include <gtest/gtest.h>
#include <math.h>  // Boost 1.74's pchip needs it

#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "support/refusal.hpp"

namespace stoss {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Knots at uneven distances whose values go up and down, with steps of equal values.
TableValues uneven_values(std::size_t count = 40) {
  std::mt19937_64 random(7);
  TableValues table;
  double logarithm = std::log(1e-4);
  for (std::size_t k = 0; k < count; ++k) {
    logarithm += 0.02 + 1e-20 * static_cast<double>(random());
    const double value = k % 7 == 3 ? table.values.back().value : 0.5 + 2e-20 * static_cast<double>(random());
    table.speeds.push_back(std::exp(logarithm));
    table.values.push_back({value, 1e-6 * static_cast<double>(k % 5)});
  }
  return table;
}

TEST(RestitutionFunction, IsTheMonotoneCubicOfBoost) {
  const TableValues given = uneven_values();
  std::vector<double> x, y;
  for (const double each : given.speeds) x.push_back(std::log(each));
  for (const Estimate& each : given.values) y.push_back(each.value);
  const auto begin = x.front(), end = x.back();
  const boost::math::interpolators::pchip boost(std::move(x), std::move(y));
  const RestitutionFunction function(given);
  for (int i = 1; i < 1000; ++i) {
    const double at = begin + (end - begin) * i / 1000.0;
    EXPECT_NEAR(function.value(std::exp(at)), boost(at), 1e-14) << at;
  }
  for (std::size_t k = 0; k < given.speeds.size(); ++k) {
    EXPECT_NEAR(function.value(given.speeds[k]), given.values[k].value, 1e-15);
    EXPECT_GE(function(given.speeds[k]).error, given.values[k].error);
  }
}

TEST(RestitutionFunction, KnowsTheErrorOfACubicThroughASmoothCurve) {
  TableValues given;
  const auto curve = [](double speed) { return 0.9 + 0.05 * std::sin(2.0 * std::log(speed)); };
  for (double x = -6.0; x < 0.0; x += 0.1) {
    given.speeds.push_back(std::exp(x));
    given.values.push_back({curve(std::exp(x)), 0.0});
  }
  const RestitutionFunction function(given);
  double worst = 0.0;
  for (double speed = function.slowest(); speed < function.fastest(); speed *= 1.003) {
    const Estimate found = function(speed);
    const double missed = std::abs(found.value - curve(speed));
    EXPECT_LE(missed, found.error) << speed;
    worst = std::max(worst, missed);
  }
  EXPECT_LT(function.greatest_error(), 20.0 * worst);  // and does not overstate it without measure
}

TEST(RestitutionFunction, FollowsALawBelowItsRange) {
  const TableValues given = uneven_values();
  const double slow = 0.9 * given.speeds.front(), fast = 1.1 * given.speeds.back();
  const RestitutionFunction lawful(given, Beyond::law, [](double speed) { return Estimate{1.0 - speed, 0.5 * speed}; });
  EXPECT_EQ(lawful(-slow).value, 1.0 - slow);
  EXPECT_EQ(lawful(slow).error, 0.5 * slow);
  EXPECT_EQ(lawful.value(0.0), 1.0);
  EXPECT_EQ(lawful.value(given.speeds.back()), given.values.back().value);
  test::expect_refusal([&] { (void)lawful(fast); }, {"speed", "range"});
  for (const double speed : {nan, infinity, -infinity}) {
    test::expect_refusal([&] { (void)lawful(speed); }, {"speed", "finite"});
    test::expect_refusal([&] { (void)lawful.value(speed); }, {"speed", "finite"});
  }
}

TEST(RestitutionFunction, RefusesWhatIsNoFunction) {
  const auto refuses = [](const TableValues& values, const char* what, Beyond beyond = Beyond::error,
                          const SlowLaw& law = {}) {
    test::expect_refusal([&] { (void)RestitutionFunction(values, beyond, law); }, {what});
  };
  refuses({}, "speeds");
  refuses(uneven_values(4), "5 or more");
  refuses(uneven_values(), "there is no law", Beyond::law);
  refuses(uneven_values(), "says nothing", Beyond::law, [](double) { return Estimate{0.5, infinity}; });
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    TableValues values = uneven_values();  // of no errors of the interpolation, which are estimated
    values.speeds[7] = bad;
    refuses(values, "speeds");
  }
  TableValues values = uneven_values();
  values.values.pop_back();
  refuses(values, "restitution");
}

}  // namespace
}  // namespace stoss
