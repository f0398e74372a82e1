#include <array>

#include "arrays.hpp"
#include "frames.hpp"
#include "interpreter.hpp"
#include "stoss/bodies/disk/field.hpp"
#include "stoss/bodies/sphere/field.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss::python {
namespace {

namespace disk = bodies::disk;
namespace sphere = bodies::sphere;

using Values = std::vector<double>;
using Doubles = py::array_t<double, py::array::c_style>;

/// A displacement or a stress, by name.
template <typename Field>
struct Component {
  const char* name;
  Values Field::*of;
};

/// What is inside a kind of body: two displacements, then stresses.
struct InDisk {
  using Inside = disk::DiskField;
  using Field = disk::Field;
  using Grid = disk::PolarGrid;
  static constexpr std::array<Component<Field>, 5> components{{{"radial", &Field::radial},
                                                               {"tangential", &Field::tangential},
                                                               {"stress_rr", &Field::stress_rr},
                                                               {"stress_pp", &Field::stress_pp},
                                                               {"stress_rp", &Field::stress_rp}}};
};

struct InSphere {
  using Inside = sphere::SphereField;
  using Field = sphere::Field;
  using Grid = sphere::PolarGrid;
  static constexpr std::array<Component<Field>, 6> components{{{"radial", &Field::radial},
                                                               {"tangential", &Field::tangential},
                                                               {"stress_rr", &Field::stress_rr},
                                                               {"stress_tt", &Field::stress_tt},
                                                               {"stress_pp", &Field::stress_pp},
                                                               {"stress_rt", &Field::stress_rt}}};
};

/// Fields of several instants, one after another, in units of the first body.
struct Series {
  std::vector<Values> components;  // and von Mises stress and principal difference
  Values center;
  double size = 1.0;  // R of the body
};

template <typename Kind>
Series evaluate(double poisson, int number, const Contact& contact, const Impact& impact, const Frames& frames,
                typename Kind::Grid points, const Poll& poll) {
  const ContactGrid grid = contact_grid(contact, impact.resolution.half_width, impact.resolution.nodes);
  const std::size_t values = frames.all.size() * points.radius.size() * points.angle.size();
  const std::size_t count = Kind::components.size();
  Frame rest;
  rest.state.coordinate.resize(mode_count(contact));
  const BodyFrame body = seen_by(contact, grid, rest, number);
  const typename Kind::Inside inside(poisson, *body.body, body.points, std::move(points), poll);
  Series series;
  series.components.resize(count + 2);
  for (Values& each : series.components) each.reserve(values);
  const auto add = [&](std::size_t to, const Values& more, double unit) {
    for (const double each : more) series.components[to].push_back(each * unit);
  };
  for (const Frame& frame : frames.all) {
    if (poll) poll();
    const BodyFrame seen = seen_by(contact, grid, frame, number);
    const typename Kind::Field field = inside.at(seen.coordinate, seen.node_force, poll);
    for (std::size_t k = 0; k < count; ++k) add(k, field.*Kind::components[k].of, k < 2 ? seen.length : seen.stress);
    add(count, von_mises(field), seen.stress);
    add(count + 1, principal_difference(field), seen.stress);
    series.center.push_back(seen.center);
  }
  series.size = body.length;
  return series;
}

template <typename Kind>
py::dict fields(double poisson, int number, const Contact& contact, const Impact& impact, const Frames& frames,
                const Doubles& radius, const Doubles& angle) {
  typename Kind::Grid points{to_vector(radius), to_vector(angle)};
  const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(frames.all.size()), radius.size(), angle.size()};
  const auto poll = signal_poll();
  Series series;
  {
    const Released released;
    series = evaluate<Kind>(poisson, number, contact, impact, frames, std::move(points), poll);
  }
  py::dict all;
  const std::size_t count = Kind::components.size();
  for (std::size_t k = 0; k < count; ++k) {
    all[Kind::components[k].name] = take(std::move(series.components[k]), shape);
  }
  all["von_mises"] = take(std::move(series.components[count]), shape);
  all["principal_difference"] = take(std::move(series.components[count + 1]), shape);
  all["center"] = take(std::move(series.center));
  all["size"] = series.size;
  return all;
}

template <typename Kind>
void bind(py::module_& module, const char* name, const char* what) {
  module.def(name, &fields<Kind>, py::arg("poisson"), py::arg("number"), py::arg("contact"), py::arg("impact"),
             py::arg("frames"), py::arg("radius"), py::arg("angle"), what);
}

}  // namespace

void bind_field(py::module_& module) {
  bind<InDisk>(module, "disk_fields", "arrays of times x radii x angles, centers of the body, and its radius");
  bind<InSphere>(module, "sphere_fields", "the same on a meridian plane");
}

}  // namespace stoss::python
