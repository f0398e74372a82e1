#include <cmath>
#include <iterator>
#include <map>
#include <vector>

#include "common.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/table.hpp"

namespace bench {
namespace {

constexpr std::size_t calls = 1'000'000;  // of one task: a millisecond is a nanosecond of each

const stoss::RefinableContact& ball() {
  static const stoss::RefinableContact made(stoss::sphere(poisson_of_sphere));
  return made;
}

const stoss::RestitutionFunction& function() {
  static const stoss::RestitutionFunction made = stoss::restitution_function(ball(), 1e-4, 0.3);
  return made;
}

/// Speeds in no order, evenly in ln v.
std::vector<double> speeds() {
  std::vector<double> all;
  for (std::size_t i = 0; i < 1000; ++i) {
    const double share = std::fmod(0.6180339887 * static_cast<double>(i), 1.0);
    all.push_back(function().slowest() * std::pow(function().fastest() / function().slowest(), 0.001 + 0.998 * share));
  }
  return all;
}

/// The rival: linear in ln v between the same values, as numpy.interp has it, found by bisection of a map.
double linear(const std::map<double, double>& knots, double speed) {
  const double x = std::log(speed);
  const auto right = knots.upper_bound(x), left = std::prev(right);
  return left->second + (right->second - left->second) * (x - left->first) / (right->first - left->first);
}

}  // namespace

void add_table() {
  add("a function of the speed of a sphere, 1e-4 to 0.3 c, error 1e-3", [](benchmark::State& state) {
    std::size_t count = 0;
    for (auto _ : state) count = stoss::restitution_function(ball(), 1e-4, 0.3).knots().size();
    state.counters["speeds computed"] = static_cast<double>(count);
  });
  add("10⁶ values of that function", [](benchmark::State& state) {
    const std::vector<double> at = speeds();
    for (auto _ : state) {
      double sum = 0.0;
      for (std::size_t i = 0; i < calls; ++i) sum += function().value(at[i % at.size()]);
      benchmark::DoNotOptimize(sum);
    }
  });
  add("10⁶ values by linear interpolation in a std::map", [](benchmark::State& state) {
    const std::vector<double> at = speeds();
    std::map<double, double> knots;
    for (const stoss::Knot& knot : function().knots()) knots[std::log(knot.speed)] = knot.restitution.value;
    for (auto _ : state) {
      double sum = 0.0;
      for (std::size_t i = 0; i < calls; ++i) sum += linear(knots, at[i % at.size()]);
      benchmark::DoNotOptimize(sum);
    }
  });
}

}  // namespace bench
