#include "stoss/bodies/disk/modes.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"
#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style>;

/// The list of modes of a kind of body.
template <typename Mode>
auto listing(std::vector<Mode> (*modes)(double, double, const Poll&)) {
  return [modes](double poisson, double cutoff) {
    const Poll poll = signal_poll();
    std::vector<Mode> all;
    {
      const Released released;
      all = modes(poisson, cutoff, poll);
    }
    return take(std::move(all));
  };
}

/// The displacement of one of them.
template <typename Mode, typename Displacement>
auto inside(std::vector<Displacement> (*displacement)(double, const Mode&, const std::vector<double>&, const Poll&)) {
  return
      [displacement](double poisson, int order, double omega, double radial, double tangential, const Doubles& radii) {
        const std::vector<double> at = to_vector(radii);
        const Poll poll = signal_poll();
        std::vector<Displacement> field;
        {
          const Released released;
          field = displacement(poisson, {order, 0, omega, radial, tangential}, at, poll);
        }
        return take(std::move(field));
      };
}

/// Adds both.
template <typename Mode, typename Displacement>
void bind(py::module_& module, const std::string& body, std::vector<Mode> (*modes)(double, double, const Poll&),
          std::vector<Displacement> (*displacement)(double, const Mode&, const std::vector<double>&, const Poll&)) {
  module.def((body + "_modes").c_str(), listing(modes), py::arg("poisson"), py::arg("cutoff"),
             "structured array of order, index, omega, radial, tangential");
  module.def((body + "_displacement").c_str(), inside(displacement), py::arg("poisson"), py::arg("order"),
             py::arg("omega"), py::arg("radial"), py::arg("tangential"), py::arg("radii"),
             "structured array of radial, tangential");
}

}  // namespace

void bind_modes(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(bodies::Mode, order, index, omega, radial, tangential);
  PYBIND11_NUMPY_DTYPE(bodies::Displacement, radial, tangential);
  module.attr("min_poisson") = bodies::disk::min_poisson;
  module.attr("max_poisson") = bodies::disk::max_poisson;
  bind<bodies::disk::Mode, bodies::disk::Displacement>(module, "disk", &bodies::disk::modes,
                                                       &bodies::disk::displacement);
  bind<bodies::sphere::Mode, bodies::sphere::Displacement>(module, "sphere", &bodies::sphere::modes,
                                                           &bodies::sphere::displacement);
}

}  // namespace stoss::python
