// What the machine can do at most: multiply–adds whose operands stay in registers.
#include <array>
#include <cstddef>

#include "common.hpp"
#include "numeric/multiversion.hpp"

namespace bench {
namespace {

/// Twelve sums of four lanes each: enough that none waits for its last operation.
using Lanes = double __attribute__((vector_size(32)));
constexpr int sums = 12, lanes = 4;

STOSS_MULTIVERSION double multiply_add(long rounds, double factor) {
  std::array<Lanes, sums> sum{};
  for (int i = 0; i < sums; ++i)
    sum[static_cast<std::size_t>(i)] = Lanes{} + static_cast<double>(i);  // or they are one
  for (long round = 0; round < rounds; ++round) {
    for (Lanes& each : sum) each = each * factor + 1.0;
  }
  Lanes total{};
  for (const Lanes& each : sum) total += each;
  return total[0] + total[1] + total[2] + total[3];
}

}  // namespace

void add_peak() {
  add("peak of the machine, 10⁶ multiply–adds in registers", [](benchmark::State& state) {
    constexpr double wanted = 1e6;
    constexpr auto rounds = static_cast<long>(wanted / (sums * lanes));
    double factor = 0.5;
    for (auto _ : state) {
      benchmark::DoNotOptimize(factor);
      benchmark::DoNotOptimize(multiply_add(rounds, factor));
    }
    state.counters[work_counter] = wanted;
    state.counters[peak_counter] = 1.0;
  });
}

}  // namespace bench
