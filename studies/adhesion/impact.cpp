// Kick, drift and rotate, kick. Modes up to the cutoff have their inertia; those above answer at once. They have one
// answer for each place of the rest if (softening of the law) · (their largest compliance) < 1, so that no energy goes
// where nobody counts it.
#include "impact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stoss/quasistatic/adhesion.hpp"

namespace adhesion_study {
namespace {

constexpr long between = 16;  // steps between readings of the energy

/// Where and how fast the centre of the ball is, towards the wall.
struct Centre {
  double place, velocity;
};

}  // namespace

Result meet(const stoss::Body& body, const Law& law, double speed, const Numerics& numerics) {
  const auto rings = static_cast<std::size_t>(std::ceil(numerics.reach / numerics.width));
  const stoss::ContactPoints points{.radius = 1.0, .spacing = numerics.width, .count = rings};
  const stoss::Surface surface = body.surface(points);
  const std::vector<double> compliance = body.residual_compliance(points, {});
  const auto n = static_cast<Eigen::Index>(rings);
  Eigen::VectorXd area(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    area[i] = surface.measure[k] * std::cos(points.angle(k));  // of the wall
  }
  const Eigen::VectorXd recess = Eigen::Map<const Eigen::VectorXd>(surface.recess.data(), n);
  Faces faces(law, area, Eigen::Map<const Eigen::MatrixXd>(compliance.data(), n, n), numerics.tolerance);
  Modes modes(body, surface, numerics.step);

  const double mass = body.mass, step = numerics.step, brought = 0.5 * mass * speed * speed;
  Centre centre{-numerics.far, speed};
  Result result;
  result.rings = n;
  result.modes = modes.count();
  result.compliance = faces.largest_compliance();
  const auto kick = [&](const Eigen::VectorXd& force, double time) {
    centre.velocity -= time / mass * force.sum();
    modes.kick(force, time);
  };
  Eigen::VectorXd rest = recess.array() - centre.place;
  double start = 0.0, first = -1.0, last = 0.0;
  int returns = 0;
  bool leaves = false;
  const auto most = static_cast<long>(numerics.longest / step);
  for (long k = 0; k <= most; ++k) {
    const Eigen::VectorXd& force = faces.force(rest);
    const double sum = force.sum(), time = static_cast<double>(k) * step;
    result.push = std::max(result.push, sum);
    result.pull = std::max(result.pull, -sum);
    if (std::abs(sum) > 1e-3 * std::max(result.push, result.pull)) last = time;
    if (first < 0.0 && sum > 0.0) first = time;
    result.deepest = std::max(result.deepest, centre.place);
    result.steps = k;
    const bool gone = centre.velocity < 0.0 && centre.place < -numerics.far;
    if (k % between == 0 || gone) {
      kick(force, 0.5 * step);
      const double ringing = modes.energy();
      const double energy = 0.5 * mass * centre.velocity * centre.velocity + ringing + faces.energy();
      if (k == 0) start = energy;
      result.imbalance = (energy - start) / brought;
      result.largest = std::max(result.largest, std::abs(result.imbalance));
      result.ringing = ringing / brought;
      if (gone) {
        result.restitution = -centre.velocity / speed;
        break;
      }
      kick(force, 0.5 * step);
    } else {
      kick(force, step);
    }
    if (centre.velocity < 0.0) leaves = true;
    if (leaves && centre.velocity > 0.0) {
      leaves = false;
      if (++returns == numerics.returns) break;
    }
    centre.place += step * centre.velocity;
    modes.rotate();
    rest = recess.array() - centre.place;
    rest -= modes.place();
  }
  result.time = last - first;
  result.iterations = faces.iterations();
  result.factors = faces.factors();
  return result;
}

double Grain::jkr_speed() const {
  constexpr double mass = 4.18879020478639098;
  return stoss::quasistatic::sticking_speed({.curvature = 1.0, .softness = 1.0 / modulus()}, work, mass);
}

double Grain::cutoff() const { return modes * std::max(2.0 * tabor * tabor, 2.0) * std::cbrt(modulus() / work); }

double Grain::softening() const { return work / (range() * range()) * std::pow(ratio, 2.0 * ratio / (1.0 - ratio)); }

Numerics Grain::numerics(double speed) const {
  constexpr double mass = 4.18879020478639098;
  const double compression = std::pow(15.0 / 16.0 * mass * speed * speed / modulus(), 0.4);
  const double contact = std::cbrt(4.5 * 3.14159265358979 * work / modulus());  // under no load
  const double reach = std::sqrt(1.4 * compression + 32.0 * range() + contact * contact);
  const double cohesive = 4.0 * modulus() * range() * range() / work;
  return {.width = std::min(cohesive / 5.0, reach / 66.0) / rings,
          .reach = reach,
          .step = 0.2 / (cutoff() * steps),
          .far = 22.0 * range(),
          .tolerance = 1e-7 * range(),
          .longest = 44.0 * range() / speed + 400.0 * std::pow(work, -1.0 / 6.0)};
}

}  // namespace adhesion_study
