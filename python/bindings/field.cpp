#include "stoss/bodies/disk/field.hpp"

#include "arrays.hpp"
#include "frames.hpp"
#include "interpreter.hpp"

namespace stoss::python {
namespace {

using namespace bodies::disk;

/// Fields of several instants, one after another, in units of the first body.
struct Series {
  std::vector<double> radial, tangential, stress_rr, stress_pp, stress_rp, von_mises, principal_difference, center;
  double size = 1.0;  // R of the body

  Series() = default;
  explicit Series(std::size_t values) {
    for (auto* each : {&radial, &tangential, &stress_rr, &stress_pp, &stress_rp, &von_mises, &principal_difference}) {
      each->reserve(values);
    }
  }

  void append(const Field& field, double length, double stress) {
    const auto add = [](std::vector<double>& all, const std::vector<double>& more, double unit) {
      for (const double each : more) all.push_back(each * unit);
    };
    add(radial, field.radial, length);
    add(tangential, field.tangential, length);
    add(stress_rr, field.stress_rr, stress);
    add(stress_pp, field.stress_pp, stress);
    add(stress_rp, field.stress_rp, stress);
    add(von_mises, bodies::disk::von_mises(field), stress);
    add(principal_difference, bodies::disk::principal_difference(field), stress);
  }
};

Series evaluate(double poisson, int number, const Contact& contact, const Impact& impact, const Frames& frames,
                PolarGrid points, const Poll& poll) {
  const ContactGrid grid = contact_grid(contact, impact.half_width, impact.nodes);
  const std::size_t values = frames.all.size() * points.radius.size() * points.angle.size();
  Frame rest;
  rest.state.coordinate.resize(mode_count(contact));
  const BodyFrame body = seen_by(contact, grid, rest, number);
  const DiskField field(poisson, *body.body, body.points, std::move(points), poll);
  Series series(values);
  for (const Frame& frame : frames.all) {
    if (poll) poll();
    const BodyFrame seen = seen_by(contact, grid, frame, number);
    series.append(field.at(seen.coordinate, seen.node_force, poll), seen.length, seen.stress);
    series.center.push_back(seen.center);
  }
  series.size = body.length;
  return series;
}

}  // namespace

void bind_field(py::module_& module) {
  module.def(
      "fields",
      [](double poisson, int number, const Contact& contact, const Impact& impact, const Frames& frames,
         const py::array_t<double, py::array::c_style>& radius, const py::array_t<double, py::array::c_style>& angle) {
        using namespace py::literals;
        PolarGrid points{to_vector(radius), to_vector(angle)};
        const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(frames.all.size()), radius.size(), angle.size()};
        const auto poll = signal_poll();
        Series series;
        {
          const Released released;
          series = evaluate(poisson, number, contact, impact, frames, std::move(points), poll);
        }
        return py::dict("radial"_a = take(std::move(series.radial), shape),
                        "tangential"_a = take(std::move(series.tangential), shape),
                        "stress_rr"_a = take(std::move(series.stress_rr), shape),
                        "stress_pp"_a = take(std::move(series.stress_pp), shape),
                        "stress_rp"_a = take(std::move(series.stress_rp), shape),
                        "von_mises"_a = take(std::move(series.von_mises), shape),
                        "principal_difference"_a = take(std::move(series.principal_difference), shape),
                        "center"_a = take(std::move(series.center)), "size"_a = series.size);
      },
      py::arg("poisson"), py::arg("number"), py::arg("contact"), py::arg("impact"), py::arg("frames"),
      py::arg("radius"), py::arg("angle"), "arrays of times x radii x angles, centers of the body, and its radius");
}

}  // namespace stoss::python
