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

RestitutionFunction with(Beyond beyond, const SlowLaw& law = {}) {
  return RestitutionFunction(uneven_values(), beyond, law);
}

SlowLaw halves() {
  return [](double speed) { return Estimate{1.0 - speed, 0.5 * speed}; };
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

TEST(RestitutionFunction, CountsASpeedWithoutItsSignAndBothWaysToAValueAgree) {
  const RestitutionFunction function = with(Beyond::error);
  for (double speed = function.slowest(); speed < function.fastest(); speed *= 1.01) {
    EXPECT_EQ(function.value(-speed), function.value(speed));
    EXPECT_EQ(function(speed).value, function.value(speed));
    EXPECT_LE(function(speed).error, function.greatest_error());
  }
  EXPECT_EQ(function.value(function.fastest()), function.values().values.back().value);
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

TEST(RestitutionFunction, DoesBeyondItsRangeWhatItsMakerChose) {
  const TableValues given = uneven_values();
  const double slow = 0.9 * given.speeds.front(), fast = 1.1 * given.speeds.back();
  const RestitutionFunction refusing = with(Beyond::error);
  for (const double speed : {slow, fast, 0.0, 1e300, 1e-300}) {
    test::expect_refusal([&] { (void)refusing(speed); }, {"speed", "range"});
    test::expect_refusal([&] { (void)refusing.value(-speed); }, {"speed", "range"});
  }
  const RestitutionFunction clamped = with(Beyond::clamp);
  for (const double speed : {slow, 0.0, 1e-300, -slow}) {
    EXPECT_EQ(clamped(speed).value, given.values.front().value);
    EXPECT_EQ(clamped(speed).error, infinity);
    EXPECT_EQ(clamped.value(speed), given.values.front().value);
  }
  EXPECT_EQ(clamped(fast).value, given.values.back().value);
  EXPECT_EQ(clamped(1e300).error, infinity);
  const RestitutionFunction lawful = with(Beyond::law, halves());
  EXPECT_EQ(lawful(-slow).value, 1.0 - slow);
  EXPECT_EQ(lawful(slow).error, 0.5 * slow);
  EXPECT_EQ(lawful.value(0.0), 1.0);
  test::expect_refusal([&] { (void)lawful(fast); }, {"speed", "range"});
  for (const RestitutionFunction& function : {refusing, clamped, lawful}) {
    for (const double speed : {nan, infinity, -infinity}) {
      test::expect_refusal([&] { (void)function(speed); }, {"speed", "finite"});
      test::expect_refusal([&] { (void)function.value(speed); }, {"speed", "finite"});
    }
  }
}

TEST(RestitutionFunction, RefusesWhatIsNoFunction) {
  const auto refuses = [](const TableValues& values, const char* what) {
    test::expect_refusal([&] { (void)RestitutionFunction(values); }, {what});
  };
  refuses({}, "speeds");
  refuses(uneven_values(4), "5");
  for (const double bad : {0.0, -1.0, nan, infinity, 1e-4}) {
    TableValues values = uneven_values();
    values.speeds[7] = bad;
    refuses(values, "speed");
  }
  for (const double bad : {nan, infinity}) {
    TableValues values = uneven_values();
    values.values[7].value = bad;
    refuses(values, "converged");
    values = uneven_values();
    values.values[7].error = bad;
    refuses(values, "converged");
  }
  const auto make = [](Beyond beyond, const SlowLaw& law, const std::vector<double>& error) {
    TableValues values = uneven_values();
    values.interpolation_error = error;
    return [=] { (void)RestitutionFunction(values, beyond, law); };
  };
  test::expect_refusal(make(Beyond::law, {}, {}), {"beyond", "law"});
  const SlowLaw silent = [](double) { return Estimate{0.5, infinity}; };
  test::expect_refusal(make(Beyond::law, silent, {}), {"beyond", "says nothing"});
  test::expect_refusal(make(Beyond::error, {}, {0.0}), {"interpolation_error", "39"});
  for (const double bad : {-1.0, nan, infinity}) {
    test::expect_refusal(make(Beyond::error, {}, std::vector<double>(39, bad)), {"interpolation_error"});
  }
}

}  // namespace
}  // namespace stoss
