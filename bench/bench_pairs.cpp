#include <cmath>
#include <vector>

#include "common.hpp"
#include "stoss/table/adaptive_pairs.hpp"

namespace bench {
namespace {

constexpr std::size_t calls = 1'000'000;  // of one task: a millisecond is a nanosecond of each
constexpr double slowest = 1e-3, fastest = 0.3, greatest = 3.0;

stoss::PairTable made() {
  return stoss::pair_table(stoss::mixture(stoss::Disk{.poisson = poisson}), slowest, fastest, 1.0, greatest);
}

/// Shares in no order, evenly.
std::vector<double> shares(double step) {
  std::vector<double> all;
  for (std::size_t i = 0; i < 1000; ++i) all.push_back(std::fmod(step * static_cast<double>(i), 1.0));
  return all;
}

}  // namespace

void add_pairs() {
  add("a table of disks 1 : 1 to 1 : 3, 1e-3 to 0.3 c, error 1e-3", [](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(made().greatest_error());
  });
  add("10⁶ values of that table", [](benchmark::State& state) {
    const stoss::PairTable table = made();
    std::vector<double> speeds, ratios;
    for (const double share : shares(0.6180339887)) {
      speeds.push_back(slowest * std::pow(fastest / slowest, 0.001 + 0.998 * share));
    }
    for (const double share : shares(0.4142135624)) ratios.push_back(std::pow(greatest, 2.0 * share - 1.0));
    for (auto _ : state) {
      double sum = 0.0;
      for (std::size_t i = 0; i < calls; ++i) sum += table.value(speeds[i % 1000], ratios[i % 1000]);
      benchmark::DoNotOptimize(sum);
    }
  });
}

}  // namespace bench
