// 1 − ε² of an elastic and of a rigid ball on a half-space of the ball's material against speed, next to the theory of
// slow impacts, its law k (v/c)^{3/5}, and the same ball at a rigid wall. Writes one CSV file.
#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/quasistatic/half_space_radiation.hpp"
#include "stoss/restitution/curve.hpp"

namespace {

constexpr double poisson = 0.3;
constexpr double tolerance = 1e-3;

/// From 1e-6 to 0.2, beyond which the law of compression ends, ten in a decade.
std::vector<double> speeds() {
  std::vector<double> all;
  for (int i = -60; i <= -7; ++i) all.push_back(std::pow(10.0, 0.1 * i));
  return all;
}

/// The same with others between them. At a wall the loss is a wave in v^(-1/5): of slow balls some fifteen to a wave.
std::vector<double> speeds_at_wall() {
  const std::vector<double> all = speeds();
  std::vector<double> result{all.front()};
  for (std::size_t i = 1; i < all.size(); ++i) {
    const int steps = std::max(4, static_cast<int>(15.0 * std::pow(all[i - 1] / all.front(), -0.2)));
    for (int k = 1; k < steps; ++k) result.push_back(all[i - 1] * std::pow(all[i] / all[i - 1], 1.0 * k / steps));
    result.push_back(all[i]);
  }
  return result;
}

std::vector<stoss::Restitution> curve(const stoss::RefinableContact& contact, const std::vector<double>& at) {
  return stoss::restitution_curve(contact, at, {.each = {.tolerance = tolerance, .absolute = 0.0}});
}

std::string lost(const stoss::Restitution& r) {
  return fmt::format("{:.7g},{:.1e},{:.4g},{:.7g},{:.4f},{}", r.lost_fraction.value, r.lost_fraction.error,
                     r.finest.energy.lost_to_first, r.finest.energy.lost_to_second, r.contact_time.value, r.converged);
}

void write(fmt::ostream& out, const char* who, const stoss::RefinableContact& contact, bool rigid) {
  const stoss::quasistatic::BallOnHalfSpace bodies{.poisson = poisson, .rigid = rigid, .half_space_poisson = poisson};
  const double constant = stoss::quasistatic::radiation_constant(bodies);
  for (const stoss::Restitution& r : curve(contact, speeds())) {
    const double speed = r.finest.speed;
    const auto slow = stoss::quasistatic::half_space_radiation(stoss::quasistatic::PointLaw::center, bodies, speed);
    out.print("{},{:.6g},{},{:.8f},{:.1e},{:.8f}\n", who, speed, lost(r), slow.lost_fraction, slow.lost_fraction_error,
              constant * std::pow(speed, 0.6));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: stoss_half_space FILE\n");
    return 2;
  }
  try {
    auto out = fmt::output_file(argv[1]);
    out.print(
        "# A ball on a half-space of its material, and at a rigid wall, nu = {}, tolerance {} of 1-eps^2; made by "
        "`make results`.\n",
        poisson, tolerance);
    out.print(
        "ball,speed[c],lost_fraction,lost_fraction_error,lost_to_ball,lost_to_half_space,contact_time[R/c],converged,"
        "slow_theory,slow_theory_error,power_law\n");
    const stoss::BodyMaker ball = stoss::sphere(stoss::Sphere{.poisson = poisson});
    const stoss::BodyMaker half_space = stoss::half_space(stoss::HalfSpace{.poisson = poisson});
    write(out, "elastic", stoss::RefinableContact(ball, half_space), false);
    write(out, "rigid", stoss::RefinableContact(stoss::rigid(ball), half_space), true);
    for (const stoss::Restitution& r : curve(stoss::RefinableContact(ball), speeds_at_wall())) {
      out.print("at_wall,{:.6g},{},,,\n", r.finest.speed, lost(r));
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "stoss_half_space: {}\n", error.what());
    return 1;
  }
  return 0;
}
