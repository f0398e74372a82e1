#include <sstream>

#include "common.hpp"
#include "stoss/bodies/disk/modes.hpp"

namespace bench {

void add_modes() {
  for (const double cutoff : {25.0, 100.0, 400.0}) {
    std::ostringstream name;
    name << "modes, cutoff " << cutoff;
    add(name.str(), [cutoff](benchmark::State& state) {
      std::size_t modes = 0;
      for (auto _ : state) {
        const auto list = stoss::bodies::disk::modes(poisson, cutoff);
        modes = list.size();
        benchmark::DoNotOptimize(list.data());
      }
      state.counters["modes"] = static_cast<double>(modes);
    });
  }
}

}  // namespace bench
