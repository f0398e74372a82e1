#include "bodies/half_space/plane/bodies_along.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "bodies/half_space/plane/residual.hpp"
#include "bodies/half_space/residual.hpp"

namespace stoss::bodies::half_space {
namespace {

using Waves = std::shared_ptr<const std::vector<PlaneWaves>>;

/// (k,±) = (cos ky | ± sin ky) or (J₀(kr) | ± J₁(kr)), first (k,+), then (k,−) of every wave number.
Surface plane_surface(const Medium& medium, Parity parity, const std::vector<PlaneWaves>& all,
                      const ContactPoints& points) {
  const bool even = parity == Parity::normal_even;
  Surface surface;
  for (const bool first : {true, false}) {
    const double speed = first == even ? medium.pressure_speed : medium.shear_speed;
    for (std::size_t i = 0; i < points.count; ++i) {
      const double inner = points.radius * std::sin(static_cast<double>(i) * points.spacing);
      const double outer = points.radius * std::sin(static_cast<double>(i + 1) * points.spacing);
      surface.recess.push_back(0.0);
      surface.measure.push_back(medium.measure(inner, outer));
      surface.impedance.push_back(surface.measure.back() * speed);
    }
  }
  for (const PlaneWaves& waves : all) {
    for (const double sign : {1.0, -1.0}) {
      for (std::size_t i = 0; i < points.count; ++i) {
        surface.shape.push_back(medium.shape(waves.wave_number * lateral_distance(points, i)));
      }
      for (std::size_t i = 0; i < points.count; ++i) {
        surface.shape.push_back(sign * medium.slope(waves.wave_number * lateral_distance(points, i)));
      }
    }
  }
  return surface;
}

std::vector<ModeGroup> plane_groups(Parity parity, const std::vector<PlaneWaves>& all) {
  const bool even = parity == Parity::normal_even;
  std::vector<ModeGroup> groups;
  for (const PlaneWaves& waves : all) {
    const std::size_t plus = 2 * groups.size(), minus = plus + 1;
    ModeGroup group{static_cast<int>(groups.size()),
                    waves.omega,
                    {},
                    {},
                    even ? plus : minus,
                    even ? minus : plus,
                    {},
                    waves.wave_number};
    for (std::size_t l = 0; l < waves.omega.size(); ++l) {
      const double upper = 0.5 * (waves.normal[l] + waves.along[l]);
      group.upper.push_back(even ? upper : -upper);
      group.lower.push_back(0.5 * (waves.normal[l] - waves.along[l]));
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

/// The blocks of these parities.
std::vector<Body> blocks(const Body& plane, const Medium& medium, double duration, const std::vector<Parity>& parities,
                         const Poll& poll) {
  const double highest = kept_cutoff(plane);
  const Waves waves = std::make_shared<const std::vector<PlaneWaves>>(plane_waves(medium, highest, duration, poll));
  const auto residual = std::make_shared<const PlaneResidual>(medium, highest, waves);
  return of_parities(
      parities, plane, [&](Parity parity) { return plane_groups(parity, *waves); },
      [medium, waves](Parity parity, const ContactPoints& points) {
        return plane_surface(medium, parity, *waves, points);
      },
      residual);
}

}  // namespace

std::vector<Body> planes_along(const Body& plane, const Medium& medium, double duration, const Poll& poll) {
  return blocks(plane, medium, duration, {Parity::normal_even, Parity::along_even}, poll);
}

Body space_outward(const Body& space, const Medium& medium, double duration, const Poll& poll) {
  return blocks(space, medium, duration, {Parity::normal_even}, poll).front();
}

}  // namespace stoss::bodies::half_space
