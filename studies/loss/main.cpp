// ε(v) of lossy spheres at a rigid wall, with the laws of a point without waves. Writes one CSV file: curves on which
// the wave of the loss dies out as the loss time grows, and single values at which the laws part.
#include <fmt/format.h>
#include <fmt/os.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

#include "stoss/bodies/sphere.hpp"
#include "stoss/quasistatic/point_lossy_impact.hpp"
#include "stoss/restitution/curve.hpp"

namespace {

using stoss::quasistatic::LossyLaw;

constexpr double poisson = 0.3, tolerance = 3e-4;
constexpr double slowest = 1e-3, fastest = 0.2;
constexpr int speeds_of_curve = 120;

/// Equally spaced in v^(-1/5), in which the wave is even.
std::vector<double> speeds() {
  std::vector<double> result;
  const double first = std::pow(slowest, -0.2), last = std::pow(fastest, -0.2);
  for (int i = 0; i < speeds_of_curve; ++i) {
    result.push_back(std::pow(first + (last - first) * i / (speeds_of_curve - 1), -5.0));
  }
  return result;
}

double point_law(LossyLaw law, double loss_time, double speed) {
  const double softness = 1.0 - poisson * poisson, mass = 4.0 * std::numbers::pi / 3.0;
  return stoss::quasistatic::lossy_impact(law, {{1.0, softness}, mass, loss_time}, speed).restitution;
}

void write(fmt::ostream& out, double loss_time, const std::vector<double>& at) {
  const stoss::RefinableContact ball(stoss::sphere(stoss::Sphere{.poisson = poisson, .loss_time = loss_time}));
  const auto line = [&](std::size_t, const stoss::Restitution& r) {
    const double speed = r.finest.speed;
    out.print("{},{:.8g},{:.10f},{:.1e},{:.7g},{:.1e},{:.6g},", loss_time, speed, r.restitution.value,
              r.restitution.error, r.lost_fraction.value, r.lost_fraction.error, r.finest.energy.dissipated);
    out.print("{:.10f},{:.10f},{}\n", point_law(LossyLaw::ting, loss_time, speed),
              point_law(LossyLaw::point, loss_time, speed), r.converged);
  };
  stoss::restitution_curve(ball, at, {.each = {.tolerance = tolerance, .absolute = 0.0}}, line);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: stoss_loss FILE\n");
    return 2;
  }
  try {
    auto out = fmt::output_file(argv[1]);
    out.print(
        "# Lossy sphere against a rigid wall, nu = {}, tolerance {} of 1-eps^2; made by `make results`. Columns: "
        "docs/understand/findings/loss.md.\n",
        poisson, tolerance);
    out.print(
        "loss_time[R/c],speed[c],restitution,restitution_error,lost_fraction,lost_fraction_error,dissipated,"
        "restitution_of_ting,restitution_of_point_law,converged\n");
    for (const double loss_time : {0.0, 0.003, 0.01, 0.03, 0.1}) write(out, loss_time, speeds());
    write(out, 0.01, {1e-5, 1e-4});
    write(out, 0.1, {0.01});
    write(out, 0.3, {0.01});
    write(out, 1.0, {1e-8, 0.01});
    write(out, 3.0, {1e-8});
    write(out, 10.0, {1e-6});
  } catch (const std::exception& error) {
    fmt::print(stderr, "stoss_loss: {}\n", error.what());
    return 1;
  }
  return 0;
}
