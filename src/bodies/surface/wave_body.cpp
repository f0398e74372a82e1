#include "bodies/surface/wave_body.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "bodies/surface/residual.hpp"

namespace stoss::bodies {
namespace {

/// Chosen as for spheres, of which fewer modes matter (docs/developer/numerics.md, section 5).
constexpr Sampling sampling{.points = 48.0, .cutoff = 8.0, .power = 0.5, .along_edge = 0.0, .fewest = 32};

/// Area, or length, that a contact point stands for.
double measure_of(const MediumSurface& medium, const ContactPoints& points, std::size_t i) {
  const double inner = points.radius * std::sin(static_cast<double>(i) * points.spacing);
  const double outer = points.radius * std::sin(static_cast<double>(i + 1) * points.spacing);
  return medium.measure(inner, outer);
}

Surface surface_of(const MediumSurface& medium, const std::vector<SurfaceWaves>& all, const ContactPoints& points) {
  Surface surface;
  for (std::size_t i = 0; i < points.count; ++i) {
    surface.recess.push_back(0.0);
    surface.measure.push_back(measure_of(medium, points, i));
    surface.impedance.push_back(surface.measure.back() * medium.leaving_speed);
  }
  std::vector<double> distance(points.count);
  for (std::size_t i = 0; i < points.count; ++i) distance[i] = lateral_distance(points, i);
  surface.shape.reserve(all.size() * points.count);
  for (const SurfaceWaves& waves : all) {
    for (const double each : distance) surface.shape.push_back(medium.shape(waves.wave_number * each));
  }
  return surface;
}

/// (k,±) = (cos ky | ± sin ky) or (J₀(kr) | ± J₁(kr)), first (k,+), then (k,−) of every wave number.
Surface plane_surface(const MediumSurface& medium, Parity parity, const std::vector<PlaneWaves>& all,
                      const ContactPoints& points) {
  const bool even = parity == Parity::normal_even;
  Surface surface;
  for (const bool first : {true, false}) {
    const double speed = first == even ? medium.pressure_speed : medium.shear_speed;
    for (std::size_t i = 0; i < points.count; ++i) {
      surface.recess.push_back(0.0);
      surface.measure.push_back(measure_of(medium, points, i));
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
                    waves.wave_number,
                    waves.moduli};
    for (std::size_t l = 0; l < waves.omega.size(); ++l) {
      const double upper = 0.5 * (waves.normal[l] + waves.along[l]);
      group.upper.push_back(even ? upper : -upper);
      group.lower.push_back(0.5 * (waves.normal[l] - waves.along[l]));
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace

Body unbounded_body(const MediumSurface& medium, double cutoff, double loss_time, double duration) {
  Body body;
  body.contour = medium.contour;
  body.curvature = 0.0;
  body.mass = 1.0;
  body.part = {1.0, std::numeric_limits<double>::infinity(), duration};
  body.softness = medium.softness;
  body.loss_time = loss_time;
  body.cutoff = cutoff;
  body.sampling = sampling;
  return body;
}

void set_waves(const MediumSurface& medium, std::vector<SurfaceWaves> kept, double highest_kept, Body& body) {
  for (SurfaceWaves& each : kept) {
    const std::size_t row = body.groups.size();
    ModeGroup group{
        static_cast<int>(row), {}, {}, std::vector<double>(each.omega.size()), row, row, {}, each.wave_number,
        std::move(each.moduli)};
    group.omega = std::move(each.omega);  // nothing asks the waves for it any more
    group.upper.reserve(each.strength.size());
    for (const double strength : each.strength) group.upper.push_back(std::sqrt(strength));
    body.groups.push_back(std::move(group));
  }
  const auto waves = std::make_shared<const std::vector<SurfaceWaves>>(std::move(kept));
  body.surface = [medium, waves](const ContactPoints& points) { return surface_of(medium, *waves, points); };
  const auto residual = std::make_shared<const WaveResidual>(medium, kept_cutoff(body), highest_kept, waves);
  body.stable_step = residual->stable_step();
  body.residual_compliance = [residual](const ContactPoints& points, const Poll& heed) {
    return residual->compliance(points, heed);
  };
  body.residual_second_moment = [residual](const ContactPoints& points, const Poll& heed) {
    return residual->second_moment(points, heed);
  };
}

std::vector<Body> plane_bodies(const Body& body, const PlaneSurface& surface, std::vector<PlaneWaves> kept,
                               const std::vector<Parity>& parities) {
  const auto waves = std::make_shared<const std::vector<PlaneWaves>>(std::move(kept));
  const auto residual = std::make_shared<const PlaneResidual>(surface, kept_cutoff(body), waves);
  return of_parities(
      parities, body, [&](Parity parity) { return plane_groups(parity, *waves); },
      [medium = surface.medium, waves](Parity parity, const ContactPoints& points) {
        return plane_surface(medium, parity, *waves, points);
      },
      residual);
}

}  // namespace stoss::bodies
