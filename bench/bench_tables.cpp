// ε(v) as other programs have it: calls of the generated header at speeds in no order. A thousand take as many
// microseconds as one takes nanoseconds.
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "common.hpp"
#include "disk_table.h"
#include "stoss/bodies/disk.hpp"
#include "stoss/table/adaptive.hpp"

namespace bench {
namespace {

std::vector<double> speeds() {
  constexpr std::size_t count = 1000;
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> logarithm(std::log(STOSS_SLOWEST), std::log(STOSS_FASTEST));
  std::vector<double> all;
  while (all.size() < count) all.push_back(std::exp(logarithm(random)));
  return all;
}

/// A thousand values, by a function of the speed.
template <typename Function>
void add_calls(const std::string& name, Function function) {
  add("1000 values of " + name, [function](benchmark::State& state) {
    const std::vector<double> at = speeds();
    for (auto _ : state) {
      double sum = 0.0;
      for (const double speed : at) sum += function(speed);
      benchmark::DoNotOptimize(sum);
    }
  });
}

}  // namespace

void add_tables() {
  add_calls("the header in C", [](double speed) { return stoss_restitution(speed); });
  add_calls("the header in C, error", [](double speed) { return stoss_restitution_error(speed); });
  const stoss::RefinableContact contact(stoss::disk(0.33));
  add_calls("RestitutionFunction", [function = stoss::restitution_function(contact, 1e-4, 0.3)](double speed) {
    return function.value(speed);
  });
}

}  // namespace bench
