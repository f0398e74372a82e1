#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/quasistatic/yield.hpp"
#include "study.hpp"

namespace study {
namespace {

constexpr double mass = 4.0 * M_PI / 3.0;

stoss::BodyMaker ball(const Pair& pair) {
  const stoss::BodyMaker elastic = stoss::sphere(stoss::Sphere{.poisson = pair.ball_poisson});
  return pair.rigid ? stoss::rigid(elastic) : elastic;
}

std::vector<stoss::Restitution> curve(const Pair& pair, const stoss::BodyMaker& other,
                                      const std::vector<double>& speeds) {
  return stoss::restitution_curve(stoss::RefinableContact(ball(pair), other), speeds);
}

/// 1/(8√(Dρh)).
double mobility(const Pair& pair, double thickness) {
  const double bending = pair.young * std::pow(thickness, 3) / (12.0 * (1.0 - pair.poisson * pair.poisson));
  return 1.0 / (8.0 * std::sqrt(bending * pair.density * thickness));
}

}  // namespace

double Pair::pressure_speed() const {
  return std::sqrt(young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson)) / density);
}

Pair pair_of(const stoss::Material& ball, const stoss::Material& plate) {
  return {ball.poisson, plate.poisson, plate.young / ball.young, plate.density / ball.density};
}

std::vector<stoss::Restitution> on_plate(const Pair& pair, double thickness, const std::vector<double>& speeds) {
  return on_layers(
      pair, {.thickness = thickness, .poisson = pair.poisson, .young = pair.young, .density = pair.density}, speeds);
}

std::vector<stoss::Restitution> on_block(const Pair& pair, const std::vector<double>& speeds) {
  return curve(pair, stoss::half_space(stoss::HalfSpace{pair.poisson, pair.young, pair.density}), speeds);
}

std::vector<stoss::Restitution> on_layers(const Pair& pair, const stoss::Plate& plate,
                                          const std::vector<double>& speeds) {
  return curve(pair, stoss::plate(plate), speeds);
}

/// s¨ + (1 + λ d/dσ) s^(3/2) = 0 with V = s˙ + λ s^(3/2), the speed of the ball: V˙ = −s^(3/2).
Zener zener(const Pair& pair, double thickness, double speed) {
  const double compliance = (1.0 - pair.poisson * pair.poisson) / pair.young +
                            (pair.rigid ? 0.0 : 1.0 - pair.ball_poisson * pair.ball_poisson);
  const double unit = std::pow(mass * compliance / (4.0 / 3.0 * std::sqrt(speed)), 0.4);
  const double lambda = mobility(pair, thickness) * mass / unit;
  using Motion = std::array<double, 2>;
  const auto rate = [lambda](const Motion& at) {
    const double force = at[0] > 0.0 ? at[0] * std::sqrt(at[0]) : 0.0;
    return Motion{at[1] - lambda * force, -force};
  };
  const auto moved = [](const Motion& at, const Motion& by, double time) {
    return Motion{at[0] + time * by[0], at[1] + time * by[1]};
  };
  constexpr double longest = 1000.0;
  Motion now{0.0, 1.0};
  double time = 0.0;
  while (time < longest) {
    const double step = std::min(1e-3, 0.1 / (1.5 * lambda * std::sqrt(std::max(now[0], 1e-12))));
    const Motion a = rate(now), b = rate(moved(now, a, 0.5 * step)), c = rate(moved(now, b, 0.5 * step));
    const Motion d = rate(moved(now, c, step));
    Motion next = now;
    for (std::size_t i = 0; i < 2; ++i) next[i] += step / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
    if (next[0] <= 0.0) {
      const double share = now[0] / (now[0] - next[0]);
      return {lambda, -(now[1] + share * (next[1] - now[1])), (time + share * step) * unit};
    }
    now = next;
    time += step;
  }
  return {lambda, 0.0, INFINITY};
}

double deflection(const Pair& pair, double thickness, double speed, double restitution) {
  return mobility(pair, thickness) * mass * speed * (1.0 + restitution) / thickness;
}

std::string yield_speed(const stoss::Material& ball, double radius, const stoss::Material& block) {
  const std::optional<double> speed = stoss::quasistatic::yield_speed(ball, radius, block, INFINITY);
  return speed ? fmt::format("{:.3g}", *speed) : "";
}

std::vector<double> series(double from, double to, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(from * std::pow(to / from, i / (count - 1.0)));
  return all;
}

}  // namespace study
