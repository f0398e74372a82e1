#include "stoss/restitution/extrapolation.hpp"

#include "arrays.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"

namespace stoss::python {

void bind_extrapolation(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(Estimate, value, error);
  PYBIND11_NUMPY_DTYPE(SoftImpact, cutoff, modes, hardness, lost_fraction, steps);
  module.def(
      "extrapolated_restitution",
      [](double poisson, double speed, const py::array_t<double, py::array::c_style>& cutoffs,
         const py::array_t<double, py::array::c_style>& hardnesses) {
        using namespace py::literals;
        const ExtrapolationOptions options{to_vector(cutoffs), to_vector(hardnesses), signal_poll()};
        ExtrapolatedRestitution result;
        {
          const Released released;
          result = extrapolated_restitution(poisson, speed, options);
        }
        return py::dict("restitution"_a = result.restitution.value, "restitution_error"_a = result.restitution.error,
                        "lost_fraction"_a = result.lost_fraction.value,
                        "lost_fraction_error"_a = result.lost_fraction.error,
                        "hard_wall"_a = take(std::move(result.hard_wall)),
                        "impacts"_a = take(std::move(result.impacts)), "steps"_a = result.steps);
      },
      py::arg("poisson"), py::arg("speed"), py::arg("cutoffs"), py::arg("hardnesses"));
}

}  // namespace stoss::python
