#include "stoss/bodies/disk/field.hpp"

#include "arrays.hpp"
#include "frames.hpp"
#include "interpreter.hpp"

namespace stoss::python {
namespace {

/// Fields of several instants, one after another.
struct Series {
  std::vector<double> radial, tangential, stress_rr, stress_pp, stress_rp, von_mises, principal_difference;

  Series() = default;
  explicit Series(std::size_t values) {
    for (auto* each : {&radial, &tangential, &stress_rr, &stress_pp, &stress_rp, &von_mises, &principal_difference}) {
      each->reserve(values);
    }
  }

  void append(const Field& field) {
    const auto add = [](std::vector<double>& all, const std::vector<double>& more) {
      all.insert(all.end(), more.begin(), more.end());
    };
    add(radial, field.radial);
    add(tangential, field.tangential);
    add(stress_rr, field.stress_rr);
    add(stress_pp, field.stress_pp);
    add(stress_rp, field.stress_rp);
    add(von_mises, stoss::von_mises(field));
    add(principal_difference, stoss::principal_difference(field));
  }
};

Series evaluate(double poisson, const Contact& contact, const Impact& impact, const Frames& frames, PolarGrid points,
                const Poll& poll) {
  const ContactGrid grid = contact_grid(contact, impact.half_width, impact.nodes);
  const std::size_t values = frames.all.size() * points.radius.size() * points.angle.size();
  const DiskField field(poisson, *contact.first, grid.points, std::move(points), poll);
  Series series(values);
  for (const Frame& frame : frames.all) {
    if (poll) poll();
    series.append(field.at(frame.state.coordinate, frame.node_force, poll));
  }
  return series;
}

}  // namespace

void bind_field(py::module_& module) {
  module.def(
      "fields",
      [](double poisson, const Contact& contact, const Impact& impact, const Frames& frames,
         const py::array_t<double, py::array::c_style>& radius, const py::array_t<double, py::array::c_style>& angle) {
        using namespace py::literals;
        PolarGrid points{to_vector(radius), to_vector(angle)};
        const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(frames.all.size()), radius.size(), angle.size()};
        const auto poll = signal_poll();
        Series series;
        {
          const Released released;
          series = evaluate(poisson, contact, impact, frames, std::move(points), poll);
        }
        return py::dict("radial"_a = take(std::move(series.radial), shape),
                        "tangential"_a = take(std::move(series.tangential), shape),
                        "stress_rr"_a = take(std::move(series.stress_rr), shape),
                        "stress_pp"_a = take(std::move(series.stress_pp), shape),
                        "stress_rp"_a = take(std::move(series.stress_rp), shape),
                        "von_mises"_a = take(std::move(series.von_mises), shape),
                        "principal_difference"_a = take(std::move(series.principal_difference), shape));
      },
      py::arg("poisson"), py::arg("contact"), py::arg("impact"), py::arg("frames"), py::arg("radius"), py::arg("angle"),
      "arrays of times x radii x angles");
}

}  // namespace stoss::python
