#include "common.hpp"
#include "finite_element_cases.hpp"
#include "finite_elements.hpp"

namespace bench {

/// Mesh and step made before.
void add_finite_elements() {
  for (const ElementCase& task : element_cases) {
    add(label("finite elements", task.tolerance, task.at.speed), [task](benchmark::State& state) {
      FiniteElements disk(poisson, task.mesh);
      ElementCollision result;
      for (auto _ : state) result = disk.collide(task.at.speed);
      if (task.at.speed == speed) {
        count(state, result.lost_fraction);
      } else {
        count_apart(state, result.lost_fraction, task.at.lost_fraction);
      }
      count_task(state, task.at.speed, task.tolerance);
      state.counters[elements_counter] = 1.0;
      state.counters["steps"] = static_cast<double>(result.steps);
    });
  }
}

}  // namespace bench
