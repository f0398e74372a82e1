// The tangential force laws of particle codes, integrated for one slow impact of elastic spheres, ν = 0.3.
//
// Units of Hertz' impact: lengths in the maximum compression, speeds in v; along the surface all over μ and times κ.
// Then d″ = −(5/4) d^{3/2} and ξ″ = −(5/2) χ T, where sliding has T = ±d^{3/2}, and a contact that sticks as a whole
// dT = (3/2) √d dξ, which is Mindlin's 8 G* a.
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "study.hpp"

namespace study {

namespace {

/// The tangential force from the stored history, which a step moves on by `slip` at the compression d, before it d_old.
struct Law {
  std::string name;
  std::function<double(double& history, double slip, double d, double d_old)> force;
};

/// The spring holds a displacement, and the force is what it is times today's stiffness (LIGGGHTS `hertz` with
/// `history`, LAMMPS `mindlin` and `gran/hertz/history`). Sliding shortens the spring.
double spring(double stiffness, double& history, double slip, double d) {
  history += slip;
  const double k = stiffness * 1.5 * std::sqrt(d), limit = std::pow(d, 1.5);
  if (k * std::abs(history) > limit) history = std::copysign(limit / k, history);
  return k * history;
}

/// The history is the force, which grows by today's stiffness (LAMMPS `mindlin/force`).
double increment(double& history, double slip, double d) {
  const double limit = std::pow(d, 1.5);
  history = std::clamp(history + 1.5 * std::sqrt(d) * slip, -limit, limit);
  return history;
}

double shrink(double d, double d_old) { return d < d_old ? std::sqrt(d / d_old) : 1.0; }

std::vector<Law> laws() {
  const double default_ratio = 2.0 / 7.0 * 4.0 / 3.0 / (2.0 * kappa(sphere_poisson));  // k_t = 2/7 k_n over 8 G*
  return {
      {"history", [](double& h, double slip, double d, double) { return spring(1.0, h, slip, d); }},
      {"history_2/7", [=](double& h, double slip, double d, double) { return spring(default_ratio, h, slip, d); }},
      {"rescale",
       [](double& h, double slip, double d, double d_old) {
         h *= shrink(d, d_old);
         return spring(1.0, h, slip, d);
       }},
      {"force", [](double& h, double slip, double d, double) { return increment(h, slip, d); }},
      {"rescale_force",
       [](double& h, double slip, double d, double d_old) {
         h *= shrink(d, d_old);
         return increment(h, slip, d);
       }},
  };
}

constexpr int steps = 40000;

/// ε_t at x by a law of a Hertzian contact: leapfrog.
double hertzian(const Law& law, double x) {
  const double start = kappa(sphere_poisson) * x, dt = 2.9433 / steps;
  double d = 0.0, d_speed = 1.0, speed = start, history = 0.0;
  while (true) {
    const double half = d_speed - 0.5 * dt * 1.25 * std::pow(d, 1.5), old = d;
    d += dt * half;
    if (d <= 0.0) break;
    d_speed = half - 0.5 * dt * 1.25 * std::pow(d, 1.5);
    speed -= dt * 2.5 * chi(sphere_poisson) * law.force(history, dt * speed, d, old);
  }
  return -speed / start;
}

/// ε_t at x of springs with k_t = ratio · k_n (LAMMPS `gran/hooke/history`; LIGGGHTS `hooke`): d = sin t.
double linear(double ratio, double x) {
  const double dt = M_PI / steps;
  double speed = x, history = 0.0;
  for (int i = 1; i < steps; ++i) {
    const double d = std::sin(i * dt);
    history += dt * speed;
    if (ratio * std::abs(history) > d) history = std::copysign(d / ratio, history);
    speed -= dt * sphere_yield * ratio * history;
  }
  return -speed / x;
}

}  // namespace

void write_dem(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print("# eps_t of elastic spheres, nu = {}, by the laws of particle codes; made by `make results`.\n",
            sphere_poisson);
  out.print("law,x,tangential_restitution\n");
  for (const double x : range(0.1, 8.0, 0.1)) {
    for (const Law& law : laws()) out.print("{},{:.3g},{:.5f}\n", law.name, x, hertzian(law, x));
    out.print("linear_2/7,{:.3g},{:.5f}\n", x, linear(2.0 / 7.0, x));
    out.print("linear_1,{:.3g},{:.5f}\n", x, linear(1.0, x));
  }
}

}  // namespace study
