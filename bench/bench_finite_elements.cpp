#include <sstream>
#include <string>

#include "common.hpp"
#include "element_collision.hpp"
#include "finite_element_cases.hpp"

namespace bench {
namespace {

std::string name_of_sphere_task(const char* what, double tolerance, double at) {
  std::ostringstream text;
  text << "finite elements of a sphere" << what << " to " << tolerance << ", v = " << at;
  return text.str();
}

void add_disk(const ElementCase& task) {
  add(label("finite elements", task.tolerance, task.at.speed), [task](benchmark::State& state) {
    FiniteElements disk(Symmetry::plane, poisson, half_disk(Symmetry::plane, task.mesh));
    ElementCollision result;
    for (auto _ : state) result = collide(disk, task.at.speed);
    if (task.at.speed == speed) {
      count(state, result.lost_fraction);
    } else {
      count_apart(state, result.lost_fraction, task.at.lost_fraction);
    }
    count_task(state, task.at.speed, task.tolerance);
    state.counters[elements_counter] = 1.0;
  });
}

void add_sphere(const ElementCase& task) {
  add(name_of_sphere_task("", task.tolerance, task.at.speed), [task](benchmark::State& state) {
    FiniteElements ball(Symmetry::axial, poisson_of_sphere, half_disk(Symmetry::axial, task.mesh));
    ElementCollision result;
    for (auto _ : state) result = collide(ball, task.at.speed);
    count_apart(state, result.lost_fraction, task.at.lost_fraction);
    count_sphere_task(state, false, task.at.speed, task.tolerance);
    state.counters[elements_counter] = 1.0;
  });
}

void add_sphere_on_half_space(const BlockElementCase& task) {
  add(name_of_sphere_task(" on a half-space", task.tolerance, task.at.speed), [task](benchmark::State& state) {
    FiniteElements ball(Symmetry::axial, poisson_of_sphere, half_disk(Symmetry::axial, task.mesh));
    FiniteElements below(Symmetry::axial, poisson_of_sphere, block(task.mesh, task.block));
    ElementCollision result;
    for (auto _ : state) result = collide(ball, below, task.at.speed);
    count_apart(state, result.lost_fraction, task.at.lost_fraction);
    count_sphere_task(state, true, task.at.speed, task.tolerance);
    state.counters[elements_counter] = 1.0;
  });
}

}  // namespace

/// Meshes and steps made before.
void add_finite_elements() {
  for (const ElementCase& task : disk_element_cases) add_disk(task);
  for (const ElementCase& task : sphere_element_cases) add_sphere(task);
  for (const BlockElementCase& task : block_element_cases) add_sphere_on_half_space(task);
}

}  // namespace bench
