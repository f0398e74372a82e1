#include "stoss/motion.hpp"

#include "arrays.hpp"
#include "frames.hpp"
#include "interpreter.hpp"

namespace stoss::python {
namespace {

/// A Frame without what belongs to modes and nodes.
struct FrameSummary {
  double time, center, velocity, force, contact_half_width;
};

std::vector<FrameSummary> summaries(const Frames& frames) {
  std::vector<FrameSummary> list;
  list.reserve(frames.all.size());
  for (const Frame& frame : frames.all) {
    list.push_back({frame.time, frame.state.center, frame.state.velocity, frame.force, frame.contact_half_width});
  }
  return list;
}

}  // namespace

void bind_motion(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(FrameSummary, time, center, velocity, force, contact_half_width);
  py::class_<Frames> handle(module, "Frames", "An impact at some times, with the motion of all modes.");
  seal(handle);
  handle.def("summaries", [](const Frames& frames) { return take(summaries(frames)); });
  module.def(
      "motion",
      [](const Body& body, const Impact& impact, const py::array_t<double, py::array::c_style>& times) {
        const std::vector<double> at = to_vector(times);
        const auto poll = signal_poll();
        const Released released;
        return Frames{motion(body, impact, at, poll)};
      },
      py::arg("body"), py::arg("impact"), py::arg("times"));
}

}  // namespace stoss::python
