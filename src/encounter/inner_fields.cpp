#include "stoss/encounter/inner_fields.hpp"

#include <array>
#include <variant>

#include "encounter/field_of.hpp"
#include "stoss/bodies/disk/field.hpp"
#include "stoss/bodies/sphere/field.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

namespace disk_inside = bodies::disk;
namespace sphere_inside = bodies::sphere;

/// A displacement or a stress, by name.
template <typename Field>
struct Component {
  std::string_view name;
  std::vector<double> Field::*of;
};

/// What is inside a kind of body: two displacements, then stresses.
struct InDisk {
  using Inside = disk_inside::DiskField;
  using Field = disk_inside::Field;
  using Grid = disk_inside::PolarGrid;
  static constexpr std::array<Component<Field>, 5> components{{{"radial", &Field::radial},
                                                               {"tangential", &Field::tangential},
                                                               {"stress_rr", &Field::stress_rr},
                                                               {"stress_pp", &Field::stress_pp},
                                                               {"stress_rp", &Field::stress_rp}}};
};

struct InSphere {
  using Inside = sphere_inside::SphereField;
  using Field = sphere_inside::Field;
  using Grid = sphere_inside::PolarGrid;
  static constexpr std::array<Component<Field>, 6> components{{{"radial", &Field::radial},
                                                               {"tangential", &Field::tangential},
                                                               {"stress_rr", &Field::stress_rr},
                                                               {"stress_tt", &Field::stress_tt},
                                                               {"stress_pp", &Field::stress_pp},
                                                               {"stress_rt", &Field::stress_rt}}};
};

template <typename Kind>
InnerFields inside(double poisson, int number, const Contact& contact, const Impact& impact,
                   const std::vector<Frame>& frames, typename Kind::Grid points, const Poll& poll) {
  const ContactGrid grid = contact_grid(contact, impact.resolution.half_width, impact.resolution.nodes);
  const std::size_t values = frames.size() * points.radius.size() * points.angle.size();
  constexpr std::size_t count = Kind::components.size();
  Frame rest;
  rest.state.coordinate.resize(mode_count(contact));
  const BodyFrame body = seen_by(contact, grid, rest, number);
  const typename Kind::Inside within(poisson, *body.body, body.points, std::move(points), poll);
  InnerFields all;
  for (const auto& [name, of] : Kind::components) all.fields.emplace_back(name, std::vector<double>{});
  all.fields.emplace_back("von_mises", std::vector<double>{});
  all.fields.emplace_back("principal_difference", std::vector<double>{});
  for (auto& [name, field] : all.fields) field.reserve(values);
  const auto add = [&](std::size_t to, const std::vector<double>& more, double unit) {
    if (poll) poll();
    for (const double each : more) all.fields[to].second.push_back(each * unit);
  };
  for (const Frame& frame : frames) {
    if (poll) poll();
    const BodyFrame seen = seen_by(contact, grid, frame, number);
    const typename Kind::Field field = field_of(within, seen, poll);
    for (std::size_t k = 0; k < count; ++k) add(k, field.*Kind::components[k].of, k < 2 ? seen.length : seen.stress);
    add(count, von_mises(field), seen.stress);
    if (poll) poll();
    add(count + 1, principal_difference(field), seen.stress);
    all.center.push_back(seen.center);
  }
  all.size = body.length;
  return all;
}

}  // namespace

InnerFields inner_fields(const Encounter& encounter, int number, const Contact& contact, const Impact& impact,
                         const std::vector<Frame>& frames, const std::vector<double>& radius,
                         const std::vector<double>& angle, const Poll& poll) {
  const auto solid = number == 0 ? first_solid(encounter) : second_solid(encounter);
  if (solid) {
    if (const auto* its = std::get_if<Disk>(&*solid)) {
      return inside<InDisk>(its->poisson, number, contact, impact, frames, {radius, angle}, poll);
    }
    if (const auto* its = std::get_if<Sphere>(&*solid)) {
      return inside<InSphere>(its->poisson, number, contact, impact, frames, {radius, angle}, poll);
    }
  }
  throw InvalidInput::conflict("body", "only disks and spheres have a field inside");
}

std::vector<ModeShare> mode_shares(const Contact& contact, const Impact& impact, const std::vector<double>& times,
                                   const Poll& poll) {
  double initial = 0.5 * contact.mass * impact.speed * impact.speed;
  if (impact.start) {
    for (const double energy : mode_energies(contact, *impact.start)) initial += energy;
  }
  std::vector<ModeShare> list;
  list.reserve(times.size() * impact.energy.modes.size());
  for (const Frame& frame : frames_at(contact, impact, times, poll)) {
    if (poll) poll();
    const std::vector<double> energies = mode_energies(contact, frame.state);
    for (std::size_t k = 0; k < energies.size(); ++k) {
      const ModeEnergy& mode = impact.energy.modes[k];
      list.push_back({mode.body, mode.order, mode.index, mode.omega, energies[k] / initial});
    }
  }
  return list;
}

}  // namespace stoss
