#include "stoss/bodies/disk/modes.hpp"

#include "arrays.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"

namespace stoss::python {

using namespace bodies::disk;

void bind_modes(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(Mode, order, index, omega, radial, tangential);
  PYBIND11_NUMPY_DTYPE(Displacement, radial, tangential);
  module.attr("min_poisson") = min_poisson;
  module.attr("max_poisson") = max_poisson;
  module.def(
      "disk_modes",
      [](double poisson, double cutoff) {
        const Poll poll = signal_poll();
        std::vector<Mode> modes;
        {
          const Released released;
          modes = bodies::disk::modes(poisson, cutoff, poll);
        }
        return take(std::move(modes));
      },
      py::arg("poisson"), py::arg("cutoff"), "structured array of order, index, omega, radial, tangential");
  module.def(
      "displacement",
      [](double poisson, int order, double omega, double radial, double tangential,
         const py::array_t<double, py::array::c_style>& radii) {
        const std::vector<double> at = to_vector(radii);
        const Poll poll = signal_poll();
        std::vector<Displacement> field;
        {
          const Released released;
          field = displacement(poisson, {order, 0, omega, radial, tangential}, at, poll);
        }
        return take(std::move(field));
      },
      py::arg("poisson"), py::arg("order"), py::arg("omega"), py::arg("radial"), py::arg("tangential"),
      py::arg("radii"), "structured array of radial, tangential");
}

}  // namespace stoss::python
