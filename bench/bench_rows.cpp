#include <string>

#include "common.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/restitution.hpp"
#include "stoss/row/row.hpp"

namespace bench {
namespace {

/// Velocities after all contacts of equal balls, the first of which moves, with all that must be made for it.
/// @param apart their distance in words
void add_row(int count, const std::string& fast, const std::string& apart = "0") {
  const std::string gaps = apart == "0" ? "" : ", " + apart + " R apart";
  const double speed_of_first = std::stod(fast), gap = std::stod(apart);
  add(std::to_string(count) + " balls in a row of a sphere" + gaps + " to 0.001, v = " + fast,
      [=](benchmark::State& state) {
        std::vector<double> speeds(static_cast<std::size_t>(count));
        speeds.front() = speed_of_first;
        for (auto _ : state) {
          const stoss::Row row{.kinds = {stoss::sphere(poisson_of_sphere)},
                               .bodies = std::vector<std::size_t>(speeds.size()),
                               .gaps = std::vector<double>(speeds.size() - 1, gap)};
          benchmark::DoNotOptimize(stoss::row(row, speeds).velocities_after.data());
        }
        state.counters[sphere_counter] = 1.0;
      });
}

}  // namespace

void add_rows() {
  // Their rival: what simulations take for a row, a collision of two at a time.
  add("one pair of a sphere to 0.001, set-up included, v = 0.1", [](benchmark::State& state) {
    for (auto _ : state) {
      const stoss::RefinableContact pair(stoss::sphere(poisson_of_sphere), stoss::sphere(poisson_of_sphere));
      benchmark::DoNotOptimize(stoss::restitution(pair, 0.1).restitution.value);
    }
    state.counters[sphere_counter] = 1.0;
  });
  add_row(2, "0.1");
  add_row(3, "0.1");
  add_row(5, "0.1");
  for (const char* const apart : {"0.001", "1", "1000"}) add_row(3, "0.1", apart);
  for (const char* const each : {"0.001", "0.01", "0.1"}) add_row(100, each);
}

}  // namespace bench
