// 1 − ε² → c(ν)v of a sphere, Rayleigh's sum of a disk, k v^{3/5} on a half-space; 1 − ε of a lossy one on top.
#include "stoss/table/slow_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic/half_space_radiation.hpp"
#include "stoss/quasistatic/point_lossy_impact.hpp"
#include "stoss/quasistatic/rayleigh.hpp"
#include "stoss/quasistatic/relaxing_impact.hpp"
#include "stoss/quasistatic/slow_impact.hpp"

namespace stoss {
namespace {

using quasistatic::CompressionLaw;
using quasistatic::PointLaw;

constexpr double highest_mode = 30.0;  // c/R; what is above it adds less than 0.2 % of the loss

/// Loss time in R/c of the body.
double own_loss_time(double loss_time, double radius, double young, double density) {
  return loss_time * std::sqrt(young / density) / radius;
}

/// ε of a loss 1 − ε² and its error, which is unknown where it is as large as ε.
Estimate of_loss(double lost, double error) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(lost < 1.0)) return {0.0, infinity};
  const double value = std::sqrt(1.0 - lost);
  // The lesser of both bounds is the one that is farther from ε.
  const double least = lost + error < 1.0 ? value - std::sqrt(1.0 - lost - error) : infinity;
  return {value, least};
}

/// A loss 1 − ε by the material together with another, 1 − ε², that the elastic body would have.
Estimate of_both(double viscous, double viscous_error, double lost, double lost_error) {
  const Estimate elastic = of_loss(lost, lost_error);
  const double value = elastic.value - viscous, error = elastic.error + viscous_error;
  return {std::max(value, 0.0), error < value ? error : std::numeric_limits<double>::infinity()};
}

/// c(ν) of the loss c(ν)v of a slow sphere.
double loss_factor(double poisson) {
  return quasistatic::mean_loss_factor(poisson, bodies::sphere::modes(poisson, highest_mode));
}

/// What a sphere keeps as vibration, relative to its mean: the wave reaches 0 and twice the mean, faster than 0.01 c
/// more.
double swing(double mean, double speed) {
  constexpr double beyond = 20.0;
  return mean * (1.0 + beyond * speed);
}

/// @param hertz 1 − ε by the material alone, by Ting's law
Estimate lossy_sphere(double hertz, double poisson, double factor, double speed) {
  const auto first_order = [&](PointLaw law) { return quasistatic::viscous_loss(law, poisson, 1.0, speed); };
  const double center = first_order(PointLaw::center) / first_order(PointLaw::hertz);
  const double viscous = hertz * center, mean = factor * speed;
  constexpr double at_crossing = 2e-3;  // where both laws are equal by chance
  return of_both(viscous, std::abs(viscous - hertz) + at_crossing * viscous, mean, swing(mean, speed));
}

Estimate lossy_disk(double poisson, double loss_time, const quasistatic::RayleighEstimate& elastic) {
  constexpr double damping_of_modes = 0.2;
  const double viscous = viscous_loss(CompressionLaw::center, poisson, loss_time, elastic.impact.speed);
  return of_both(viscous, (damping_of_modes + viscous) * viscous, elastic.lost_fraction, elastic.lost_fraction_error);
}

SlowLaw at_half_the_speed(const SlowLaw& at_wall) {
  return [at_wall](double speed) { return at_wall(0.5 * speed); };
}

InvalidInput no_law(const char* name, const char* what) {
  return InvalidInput::out_of_range(std::string(name), what,
                                    "for a law of slow impacts a sphere or a disk at a wall or against its equal, or "
                                    "an elastic sphere on an elastic half-space");
}

}  // namespace

constexpr double ball_mass = 4.0 * std::numbers::pi / 3.0;

SlowLaw slow_law(const Sphere& sphere) {
  (void)stoss::sphere(sphere);  // refuses what is out of range
  const double poisson = sphere.poisson, factor = loss_factor(poisson);
  const double loss_time = own_loss_time(sphere.loss_time, sphere.radius, sphere.young, sphere.density);
  return [=](double speed) -> Estimate {
    if (speed == 0.0) return {1.0, 0.0};
    if (loss_time > 0.0) {
      const quasistatic::LossyContact contact{{1.0, 1.0 - poisson * poisson}, ball_mass, loss_time};
      const double hertz = 1.0 - lossy_impact(quasistatic::LossyLaw::ting, contact, speed).restitution;
      return lossy_sphere(hertz, poisson, factor, speed);
    }
    const double mean = factor * speed;
    return of_loss(mean, swing(mean, speed));
  };
}

SlowLaw slow_law(const Sphere& sphere, const Relaxation& relaxation) {
  (void)stoss::sphere(sphere);
  validate(relaxation);
  const double poisson = sphere.poisson, factor = loss_factor(poisson);
  const double own = own_loss_time(1.0, sphere.radius, sphere.young, sphere.density);
  const quasistatic::RelaxingContact contact{
      1.0, {{{1.0 - poisson * poisson, in_time(relaxation, own)}, {}}}, ball_mass};
  return [=](double speed) -> Estimate {
    if (speed == 0.0) return {1.0, 0.0};
    return lossy_sphere(1.0 - relaxing_impact(contact, speed).restitution, poisson, factor, speed);
  };
}

SlowLaw slow_law(const Disk& disk) {
  (void)stoss::disk(disk);
  const double poisson = disk.poisson;
  const double loss_time = own_loss_time(disk.loss_time, disk.radius, disk.young, disk.density);
  return [poisson, loss_time, modes = bodies::disk::modes(poisson, highest_mode)](double speed) -> Estimate {
    if (speed == 0.0) return {1.0, 0.0};
    const auto elastic = quasistatic::rayleigh(CompressionLaw::center, poisson, speed, modes);
    if (loss_time > 0.0) return lossy_disk(poisson, loss_time, elastic);
    return of_loss(elastic.lost_fraction, elastic.lost_fraction_error);
  };
}

SlowLaw slow_law(const Sphere& first, const Sphere& second, const Relaxation& relaxation) {
  const bool equal = first.poisson == second.poisson && first.radius == second.radius && first.young == second.young &&
                     first.density == second.density && first.loss_time == second.loss_time;
  if (!equal) throw no_law("second", "another sphere");
  return at_half_the_speed(relaxation.terms.empty() ? slow_law(first) : slow_law(first, relaxation));
}

SlowLaw slow_law(const Disk& first, const Disk& second) {
  const bool equal = first.poisson == second.poisson && first.radius == second.radius && first.young == second.young &&
                     first.density == second.density && first.loss_time == second.loss_time;
  if (!equal) throw no_law("second", "another disk");
  return at_half_the_speed(slow_law(first));
}

SlowLaw slow_law(const Sphere& sphere, const HalfSpace& half_space, bool rigid) {
  if (sphere.loss_time != 0.0 || half_space.loss_time != 0.0) throw no_law("loss_time", "a lossy material");
  const quasistatic::BallOnHalfSpace bodies{sphere.poisson, rigid, half_space.poisson, half_space.young / sphere.young,
                                            half_space.density / sphere.density};
  (void)quasistatic::radiation_constant(bodies);  // refuses what is out of range
  const double own = 1.0 - sphere.poisson * sphere.poisson;
  const double share = own / (own + (1.0 - half_space.poisson * half_space.poisson) / bodies.young);
  const double factor = rigid ? 0.0 : loss_factor(sphere.poisson) * share * share;
  return [=](double speed) -> Estimate {
    if (speed == 0.0) return {1.0, 0.0};
    const auto radiated = quasistatic::half_space_radiation(PointLaw::center, bodies, speed);
    constexpr double least = 1e-3;  // how well it is checked against direct values
    const double kept = factor * speed, lost = radiated.lost_fraction;
    return of_loss(lost + kept, radiated.lost_fraction_error + least * lost + swing(kept, speed));
  };
}

}  // namespace stoss
