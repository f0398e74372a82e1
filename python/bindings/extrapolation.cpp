#include "stoss/restitution/extrapolation.hpp"

#include "arrays.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"
#include "quantities.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss::python {

void bind_extrapolation(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(Estimate, value, error);
  PYBIND11_NUMPY_DTYPE(SoftImpact, cutoff, modes, hardness, lost_fraction, steps);
  module.def(
      "extrapolated_restitution",
      [](double poisson, double speed, const py::array_t<double, py::array::c_style>& cutoffs,
         const py::array_t<double, py::array::c_style>& hardnesses) {
        const ExtrapolationOptions options{to_vector(cutoffs), to_vector(hardnesses), signal_poll()};
        ExtrapolatedRestitution result;
        {
          const Released released;
          result = extrapolated_restitution(poisson, speed, options);
        }
        py::dict numbers = to_dict(extrapolation_quantities(), result);
        numbers["hard_wall"] = take(std::move(result.hard_wall));
        numbers["impacts"] = take(std::move(result.impacts));  // themselves, in place of their number
        return numbers;
      },
      py::arg("poisson"), py::arg("speed"), py::arg("cutoffs"), py::arg("hardnesses"));
}

}  // namespace stoss::python
