// u = Σ_kept Q u_l + Σ F R: the profiles u_l of the kept waves, and at every wave number that R of all others together,
// of which sums over the depths are made once.
#include "stoss/bodies/plate/field.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bodies/field_arguments.hpp"
#include "bodies/plate/given.hpp"
#include "bodies/plate/plate_waves.hpp"
#include "bodies/plate/wave_profiles.hpp"
#include "bodies/surface/profile_sum.hpp"
#include "bodies/surface/residual.hpp"
#include "check.hpp"
#include "numeric/quadrature.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::plate {
namespace {

void refuse(const Given& given, const Body& body) {
  throw InvalidInput::out_of_range("body", "'" + body.name + "'", "the elastic " + name_of(given));
}

/// The waves of the surface of a body in both directions, which are of these wave numbers.
std::vector<ModeGroup> checked_waves(const Given& given, const Body& body, const std::vector<WaveNumber>& numbers) {
  if (body.groups.size() != numbers.size()) refuse(given, body);
  std::vector<ModeGroup> waves =
      given.contour == Contour::ball ? body.outward({}).groups : body.along({}).front().groups;
  for (std::size_t g = 0; g < waves.size(); ++g) {
    if (waves[g].omega != body.groups[g].omega || waves[g].wave_number != numbers[g].k) {
      refuse(given, body);
    }
  }
  return waves;
}

/// Amplitudes of both directions, of each wave of a group (plane_bodies).
std::vector<Amplitude> amplitudes_of(const ModeGroup& group) {
  std::vector<Amplitude> all;
  for (std::size_t l = 0; l < group.omega.size(); ++l) {
    all.push_back({group.omega[l], group.upper[l] + group.lower[l], group.upper[l] - group.lower[l]});
  }
  return all;
}

}  // namespace

struct PlateField::Parts {
  std::optional<half_space::HalfSpaceField> as_half_space;  ///< in place of all else
  MediumSurface medium{};                                   ///< its shapes only
  std::vector<WaveProfiles> numbers{};
  std::size_t modes = 0;
  std::vector<double> ring{};  ///< distances of the contact points
  PlaneGrid points{};

  Parts(const Given& given, const Body& body, const ContactPoints& contact, PlaneGrid grid, const Poll& poll);

  void add_kept(const Given& given, const Lamina& plate, const Body& body, const Poll& poll);

  /// Wave numbers of which no waves are kept, up to the π/h that contact points resolve.
  void add_static(const Lamina& plate, double lowest, double highest, const Poll& poll);
};

PlateField::Parts::Parts(const Given& given, const Body& body, const ContactPoints& contact, PlaneGrid grid,
                         const Poll& poll) {
  require_given(given);
  validate(body);
  if (body.name != name_of(given) || !is_unbounded(body)) refuse(given, body);
  double thickness = 0.0;
  for (const Layer& layer : given.layers) thickness += layer.thickness;
  require_points(grid, contact, thickness);
  if (is_thick(given, body.part.echo)) {
    as_half_space.emplace(given.layers.front().poisson, body, contact, std::move(grid));
    return;
  }
  const Lamina plate = lamina(given.contour, sheets_of(given, kinds_of(given, body.part.echo), body.part.echo));
  points = std::move(grid);
  modes = mode_count(body);
  medium.contour = given.contour;
  const auto profiles = static_cast<long>(modes * points.depth.size());
  require("profiles", profiles, 0, 50'000'000, "waves of the plate times depths");
  for (std::size_t i = 0; i < contact.count; ++i) ring.push_back(lateral_distance(contact, i));
  add_kept(given, plate, body, poll);
  const double top = *std::min_element(points.depth.begin(), points.depth.end());
  const double highest = std::min(std::numbers::pi / (contact.spacing * contact.radius), deepest_phase / top);
  add_static(plate, plate::highest_kept(plate, kept_cutoff(body), poll), highest, poll);
}

void PlateField::Parts::add_kept(const Given& given, const Lamina& plate, const Body& body, const Poll& poll) {
  const double cutoff = kept_cutoff(body);
  const std::vector<WaveNumber> kept = wave_numbers(plate, cutoff, body.part.echo, poll);
  const std::vector<ModeGroup> waves = checked_waves(given, body, kept);
  const ProfileMaker make(plate, points.depth);
  for (std::size_t g = 0; g < waves.size(); ++g) {
    if (poll) poll();
    numbers.push_back(make.of(kept[g], amplitudes_of(waves[g]), cutoff));
  }
}

void PlateField::Parts::add_static(const Lamina& plate, double lowest, double highest, const Poll& poll) {
  constexpr double turn = 16.0;  // of a shape times the load in a panel
  const double reach = ring.back() + *std::max_element(points.distance.begin(), points.distance.end());
  const auto& rule = numeric::gauss_legendre(16);
  const ProfileMaker make(plate, points.depth);
  for (double from = lowest; from < highest;) {
    if (poll) poll();
    const double to = std::min({highest, 2.0 * from, from + turn / reach}), half = 0.5 * (to - from);
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      numbers.push_back(make.of({from + half + half * rule.node[i], half * rule.weight[i]}));
    }
    from = to;
  }
}

PlateField::PlateField(const Plate& plate, const Body& body, const ContactPoints& contact, PlaneGrid points,
                       const Poll& poll)
    : parts_(std::make_shared<const Parts>(given_of(plate), body, contact, std::move(points), poll)) {}

PlateField::PlateField(const Strip& strip, const Body& body, const ContactPoints& contact, PlaneGrid points,
                       const Poll& poll)
    : parts_(std::make_shared<const Parts>(given_of(strip), body, contact, std::move(points), poll)) {}

Field PlateField::at(std::span<const double> coordinate, std::span<const double> node_force, const Poll& poll) const {
  const Parts& its = *parts_;
  if (its.as_half_space) return its.as_half_space->at(coordinate, node_force, poll);
  require_length("coordinate", coordinate.size(), its.modes, "one for each kept mode");
  require_length("node_force", node_force.size(), its.ring.size(), "one for each ring");
  require_finite("coordinate", coordinate, "Q of the kept modes");
  require_finite("node_force", node_force, "share of each ring in the force");
  const bool loaded = std::any_of(node_force.begin(), node_force.end(), [](double force) { return force != 0.0; });
  ProfileSum sum(its.medium, its.points, poll);
  std::size_t first = 0;
  for (const WaveProfiles& number : its.numbers) {
    const auto count = static_cast<std::size_t>(number.kept.cols());
    if (count == 0 && !loaded) continue;
    double load = 0.0;
    for (std::size_t i = 0; loaded && i < its.ring.size(); ++i) {
      load += node_force[i] * its.medium.shape(number.wave_number * its.ring[i]);
    }
    Eigen::VectorXd profile = load * number.others;
    if (count > 0) {
      profile +=
          number.kept * Eigen::Map<const Eigen::VectorXd>(coordinate.data() + first, static_cast<Eigen::Index>(count));
    }
    first += count;
    sum.start(number.wave_number);
    sum.add(1.0, [&](std::size_t depth) {
      const auto row = static_cast<Eigen::Index>(2 * depth);
      return DepthProfile{profile(row), profile(row + 1)};
    });
  }
  return sum.field();
}

}  // namespace stoss::bodies::plate
