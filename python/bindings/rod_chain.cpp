#include "stoss/vibration/rod_chain_run.hpp"

#include <pybind11/stl.h>

#include <memory>
#include <utility>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"

namespace stoss::python {
namespace {

/// A chain and what was seen of it so far.
struct WatchedChain {
  RodChain chain;
  RodChainRecord record{};
};

std::vector<Rod> rods_of(const std::vector<std::array<double, 5>>& values) {
  std::vector<Rod> rods;
  for (const auto& [length, young, density, area, loss_time] : values) {
    rods.push_back({length, young, density, area, loss_time});
  }
  return rods;
}

}  // namespace

void bind_rod_chain(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(RodCollision, time, pair, speed, restitution, vibration_before, vibration_after, unresolved);
  PYBIND11_NUMPY_DTYPE(RodChainSample, time, collisions, translation, vibration, dissipated, unresolved, momentum);
  module.def(
      "thermal_velocities",
      [](const std::vector<std::array<double, 5>>& rods, double temperature, std::uint64_t seed) {
        return take(thermal_velocities(rods_of(rods), temperature, seed));
      },
      py::arg("rods"), py::arg("temperature"), py::arg("seed"));
  py::class_<WatchedChain> chain(module, "RodChain", "A chain of rods and what was seen of it.");
  seal(chain);
  module.def(
      "rod_chain",
      [](const std::vector<std::array<double, 5>>& rods, double circumference,
         const py::array_t<double, py::array::c_style>& velocities, bool modes, int count, int pieces, bool radiating,
         std::optional<double> decay_time) {
        RodChainOptions options;
        options.method = modes ? RodMethod::modes : RodMethod::characteristics;
        options.modes = count;
        options.pieces = pieces;
        options.resolution.tail = radiating ? Tail::radiating : Tail::quasistatic;
        options.decay_time = decay_time;
        options.poll = signal_poll();
        return WatchedChain{RodChain(rods_of(rods), circumference, to_vector(velocities), options)};
      },
      py::arg("rods"), py::arg("circumference"), py::arg("velocities"), py::arg("modes"), py::arg("count"),
      py::arg("pieces"), py::arg("radiating"), py::arg("decay_time"));
  chain.def(
      "run",
      [](WatchedChain& self, long collisions, double time) {
        const Released released;
        run(self.chain, self.record, collisions, time);
      },
      py::arg("collisions"), py::arg("time"));
  chain.def("collisions", [](const WatchedChain& self) { return take(std::vector(self.record.collisions)); });
  chain.def("samples", [](const WatchedChain& self) { return take(std::vector(self.record.samples)); });
  chain.def("velocities", [](const WatchedChain& self) { return take(self.chain.velocities()); });
}

}  // namespace stoss::python
