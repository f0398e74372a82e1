#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

#include "common.hpp"
#include "rule_table.h"
#include "sphere_table.h"
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

const stoss::RuleTable& rule() {
  static const stoss::RuleTable made =
      stoss::rule_table(stoss::RefinableContact(stoss::sphere(poisson_of_sphere), stoss::sphere(poisson_of_sphere)),
                        1e-4, 1e-2, {.beyond = stoss::Beyond::clamp});
  return made;
}

/// Pairs of balls that meet at many angles, with spins.
template <typename Body>
std::vector<std::array<Body, 2>> meetings() {
  std::vector<std::array<Body, 2>> all(1000);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto share = [i](double step) { return std::fmod(step * static_cast<double>(i), 1.0) - 0.5; };
    for (Body& each : all[i]) {
      each.inverse_mass = 1.0, each.inverse_inertia = 2.5, each.radius = 1.0;
      for (std::size_t k = 0; k < 3; ++k) each.velocity[k] = 0.0, each.spin[k] = 0.003 * share(0.3247179572);
    }
    Body& first = all[i].front();
    first.velocity[0] = 0.003 + 0.005 * share(0.1180339887), first.velocity[1] = 0.02 * share(0.6180339887);
  }
  return all;
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
    for (auto _ : state) count = stoss::restitution_function(ball(), 1e-4, 0.3).values().speeds.size();
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
  add("10⁶ values of that function as a header in C", [](benchmark::State& state) {
    const std::vector<double> at = speeds();
    for (auto _ : state) {
      double sum = 0.0;
      for (std::size_t i = 0; i < calls; ++i) sum += stoss_restitution(at[i % at.size()]);
      benchmark::DoNotOptimize(sum);
    }
  });
  add("the collision rule of two spheres, 1e-4 to 0.01 c, tolerance 0.02", [](benchmark::State& state) {
    std::size_t count = 0;
    for (auto _ : state) {
      const stoss::RefinableContact balls(stoss::sphere(poisson_of_sphere), stoss::sphere(poisson_of_sphere));
      count = stoss::rule_table(balls, 1e-4, 1e-2, {.threads = 1}).values().sliding.values.size();
    }
    state.counters["values computed"] = static_cast<double>(count);
  });
  add("10⁶ collisions by that rule", [](benchmark::State& state) {
    const auto pairs = meetings<stoss::MovingBody<3>>();
    for (auto _ : state) {
      double sum = 0.0;
      for (std::size_t i = 0; i < calls; ++i) {
        auto [a, b] = pairs[i % pairs.size()];
        collide(rule(), a, b, {1.0, 0.0, 0.0}, 0.3);
        sum += a.spin[2];
      }
      benchmark::DoNotOptimize(sum);
    }
  });
  add("10⁶ values of that rule as a header in C", [](benchmark::State& state) {
    const std::vector<double> at = speeds();
    for (auto _ : state) {
      double sum = 0.0;
      for (std::size_t i = 0; i < calls; ++i) {
        const double v = 0.02 * at[i % at.size()];
        sum += stoss_rule_sliding(v, 0.002 * static_cast<double>(i % 7), 0.3, 1.0);
      }
      benchmark::DoNotOptimize(sum);
    }
  });
  add("10⁶ collisions by that header in C", [](benchmark::State& state) {
    const double normal[3] = {1.0, 0.0, 0.0};
    const auto pairs = meetings<stoss_rule_body_3d>();
    for (auto _ : state) {
      double sum = 0.0;
      for (std::size_t i = 0; i < calls; ++i) {
        auto [a, b] = pairs[i % pairs.size()];
        stoss_rule_collide_3d(&a, &b, normal, 0.3);
        sum += a.spin[2];
      }
      benchmark::DoNotOptimize(sum);
    }
  });
  add("10⁶ values by linear interpolation in a std::map", [](benchmark::State& state) {
    const std::vector<double> at = speeds();
    std::map<double, double> knots;
    const stoss::TableValues& values = function().values();
    for (std::size_t k = 0; k < values.speeds.size(); ++k) knots[std::log(values.speeds[k])] = values.values[k].value;
    for (auto _ : state) {
      double sum = 0.0;
      for (std::size_t i = 0; i < calls; ++i) sum += linear(knots, at[i % at.size()]);
      benchmark::DoNotOptimize(sum);
    }
  });
}

}  // namespace bench
