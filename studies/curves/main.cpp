// ε(v) for several Poisson's ratios, with what explains it: the contact time against the period of the quadrupole mode
// (2,0), that mode's share of the loss, and the quasi-static estimate. Writes one CSV file.
#include <fmt/format.h>
#include <fmt/os.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/quasistatic/rayleigh.hpp"
#include "stoss/restitution/curve.hpp"

namespace {

constexpr double tolerance = 3e-4;

std::vector<double> series(double from, double to, int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(from * std::pow(to / from, i / (count - 1.0)));
  return result;
}

double frequency_of_quadrupole(const std::vector<stoss::bodies::disk::Mode>& modes) {
  for (const stoss::bodies::disk::Mode& mode : modes) {
    if (mode.order == 2 && mode.index == 0) return mode.omega;
  }
  return std::nan("");
}

double energy_of_quadrupole(const stoss::Impact& impact) {
  for (const stoss::ModeEnergy& mode : impact.energy.modes) {
    if (mode.order == 2 && mode.index == 0) return mode.after;
  }
  return std::nan("");
}

/// The quasi-static estimate, where it has a meaning.
std::string estimate(double poisson, double speed, const std::vector<stoss::bodies::disk::Mode>& modes) {
  using stoss::quasistatic::CompressionLaw;
  if (speed > 0.9 * stoss::quasistatic::limit_speed(CompressionLaw::center, poisson)) return ",";
  const stoss::quasistatic::RayleighEstimate slow =
      stoss::quasistatic::rayleigh(CompressionLaw::center, poisson, speed, modes);
  if (slow.beyond_perturbation) return ",";
  return fmt::format("{:.5f},{:.6g}", slow.impact.contact_time, slow.lost_fraction);
}

void write_curve(fmt::ostream& out, double poisson, const std::vector<double>& speeds) {
  const std::vector<stoss::bodies::disk::Mode> modes = stoss::bodies::disk::modes(poisson, 60.0);
  const double period = 2.0 * std::numbers::pi / frequency_of_quadrupole(modes);
  for (const stoss::Restitution& r :
       stoss::restitution_curve(poisson, speeds, {.each = {.tolerance = tolerance, .absolute = 0.0}})) {
    const double speed = r.finest.speed;
    out.print("{},{:.8g},{:.8f},{:.1e},{:.6g},{:.1e},", poisson, speed, r.restitution.value, r.restitution.error,
              r.lost_fraction.value, r.lost_fraction.error);
    out.print("{:.5f},{:.1e},{:.6g},{:.6g},", r.contact_time.value, r.contact_time.error, r.max_force.value,
              r.max_compression.value);
    out.print("{:.5f},{:.4f},{},{}\n", r.contact_time.value / period,
              energy_of_quadrupole(r.finest) / r.lost_fraction.value, estimate(poisson, speed, modes), r.converged);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: stoss_curves FILE\n");
    return 2;
  }
  try {
    auto out = fmt::output_file(argv[1]);
    out.print(
        "# Disk against a hard wall, tolerance {} of 1-eps^2; made by `make results`. Quasi-static: "
        "docs/understand/findings/wall.md.\n",
        tolerance);
    out.print(
        "poisson,speed[c],restitution,restitution_error,lost_fraction,lost_fraction_error,contact_time[R/c],"
        "contact_time_error,max_force[piRE],max_compression[R],contact_time_over_quadrupole_period,"
        "quadrupole_share_of_loss,quasistatic_contact_time[R/c],quasistatic_lost_fraction,converged\n");
    for (const double poisson : {0.0, 0.2, 0.33, 0.5, 0.9}) write_curve(out, poisson, series(1e-6, 0.5, 115));
    // Further down, for one Poisson's ratio.
    std::vector<double> slower = series(1e-8, 1e-6, 41);
    slower.pop_back();
    write_curve(out, 0.33, slower);
  } catch (const std::exception& error) {
    fmt::print(stderr, "stoss_curves: {}\n", error.what());
    return 1;
  }
  return 0;
}
