// ε(v) of a sphere at a rigid wall, with what explains it: Rayleigh's estimate, the law of the ends of Hertz's pulse,
// its mean over the phases, and the share of the quadrupole mode (2,0). Writes one CSV file.
//
// The loss over v is a wave in v^(-1/5): the speeds are dense enough for twenty of them to each wave of the quadrupole.
#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "stoss/bodies/sphere.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/quasistatic/rayleigh.hpp"
#include "stoss/restitution/curve.hpp"

namespace {

using stoss::bodies::sphere::Mode;
using stoss::quasistatic::PointLaw;
using stoss::quasistatic::RayleighEstimate;

constexpr double pi = std::numbers::pi;
constexpr double tolerance = 1e-3;
constexpr double slowest = 1e-6, fastest = 0.5;
constexpr double per_decade = 30.0, per_wave = 20.0;

const Mode& quadrupole(const std::vector<Mode>& modes) {
  for (const Mode& mode : modes) {
    if (mode.order == 2 && mode.index == 0) return mode;
  }
  throw std::logic_error("no quadrupole");
}

/// Speeds from the slowest on. cos²(ωτ/2 + …) repeats when ωτ changes by 2π, and τ falls by a fifth of d ln v.
std::vector<double> speeds(double poisson, double omega) {
  std::vector<double> result;
  const double tau = stoss::quasistatic::slow_impact(PointLaw::hertz, poisson, slowest).contact_time;
  for (double speed = slowest; speed < fastest;) {
    result.push_back(speed);
    const double wave = 10.0 * pi / (omega * tau * std::pow(speed / slowest, -0.2));
    speed *= std::exp(std::min(wave / per_wave, std::numbers::ln10 / per_decade));
  }
  result.push_back(fastest);
  return result;
}

/// 1 − ε² by the ends of Hertz's pulse alone (docs/theory/points.md), with the contact time of the law of the centre.
/// @param share 1, or 0 without the phase Φ that the stiffness of the contact adds
double loss_of_ends(const RayleighEstimate& slow, const std::vector<Mode>& modes, double share) {
  const double modulus = 1.0 / (1.0 - slow.impact.poisson * slow.impact.poisson), mass = 4.0 * pi / 3.0;
  const double contact =
      share * 0.5549 * 4.0 * modulus * std::pow(slow.impact.max_radius, 3.0) / (mass * slow.impact.speed);
  double sum = 0.0;
  for (const Mode& mode : modes) {
    const double square = mode.radial * mode.radial;
    const double wave =
        std::cos(0.5 * (mode.omega * slow.impact.contact_time + contact * square / mode.omega - 2.5 * pi));
    sum += square / std::pow(mode.omega, 5.0) * wave * wave;
  }
  return slow.impact.speed * 4.0 * pi * std::pow(modulus / mass, 2.0) * sum;
}

/// The quasi-static columns, where they have a meaning.
std::string estimate(double poisson, double speed, const std::vector<Mode>& modes) {
  if (speed > 0.9 * stoss::quasistatic::limit_speed(PointLaw::center, poisson)) return ",,,,";
  const RayleighEstimate slow = stoss::quasistatic::rayleigh(PointLaw::center, poisson, speed, modes);
  if (slow.beyond_perturbation) return ",,,,";
  return fmt::format("{:.5f},{:.6g},{:.1e},{:.6g},{:.6g}", slow.impact.contact_time, slow.lost_fraction,
                     slow.lost_fraction_error, loss_of_ends(slow, modes, 1.0), loss_of_ends(slow, modes, 0.0));
}

void write_curve(fmt::ostream& out, double poisson) {
  const std::vector<Mode> modes = stoss::bodies::sphere::modes(poisson, 60.0);
  const Mode slow = quadrupole(modes);
  const double mean = stoss::quasistatic::mean_loss_factor(poisson, modes);
  const double mean_of_quadrupole = stoss::quasistatic::mean_loss_factor(poisson, {slow});
  const stoss::RefinableContact ball(stoss::sphere(poisson));
  const auto write = [&](std::size_t, const stoss::Restitution& r) {
    const double speed = r.finest.speed;
    double share = 0.0;
    for (const stoss::ModeEnergy& mode : r.finest.energy.modes) {
      if (mode.order == 2 && mode.index == 0) share = mode.after / r.lost_fraction.value;
    }
    out.print("{},{:.8g},{:.13f},{:.1e},{:.6g},{:.1e},", poisson, speed, r.restitution.value, r.restitution.error,
              r.lost_fraction.value, r.lost_fraction.error);
    out.print("{:.5f},{:.1e},{:.6g},{:.6g},", r.contact_time.value, r.contact_time.error, r.max_force.value,
              r.max_compression.value);
    out.print("{:.5f},{:.4f},{:.6g},{:.6g},", 0.5 * r.contact_time.value * slow.omega / pi, share, mean,
              mean_of_quadrupole);
    out.print("{},{}\n", estimate(poisson, speed, modes), r.converged);
  };
  stoss::restitution_curve(ball, speeds(poisson, slow.omega), {.each = {.tolerance = tolerance, .absolute = 0.0}},
                           write);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: stoss_spheres FILE\n");
    return 2;
  }
  try {
    auto out = fmt::output_file(argv[1]);
    out.print(
        "# Sphere against a rigid wall, tolerance {} of 1-eps^2; made by `make results`. Columns: "
        "docs/understand/findings/spheres.md.\n",
        tolerance);
    out.print(
        "poisson,speed[c],restitution,restitution_error,lost_fraction,lost_fraction_error,contact_time[R/c],"
        "contact_time_error,max_force[mc^2/R],max_compression[R],contact_time_over_quadrupole_period,"
        "quadrupole_share_of_loss,mean_loss_factor,mean_loss_factor_of_quadrupole,quasistatic_contact_time[R/c],"
        "quasistatic_lost_fraction,quasistatic_error,lost_fraction_of_ends,lost_fraction_of_ends_without_phase,"
        "converged\n");
    for (const double poisson : {0.0, 0.2, 0.3, 0.45, 0.49}) write_curve(out, poisson);
  } catch (const std::exception& error) {
    fmt::print(stderr, "stoss_spheres: {}\n", error.what());
    return 1;
  }
  return 0;
}
