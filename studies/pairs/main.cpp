// ε of two disks of one material against the ratio of their radii, and who keeps the loss. Writes one CSV file.
//
// ε does not depend on which disk is called the first, so that R₂/R₁ ≥ 1 stands for R₁/R₂ too. Two rods of one material
// and section have ε = l₁/l₂, l₁ ≤ l₂, at every speed.
#include <fmt/format.h>
#include <fmt/os.h>

#include <cstdio>
#include <exception>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/restitution/curve.hpp"

namespace {

constexpr double poisson = 0.33;
constexpr double tolerance = 1e-3;
// The last one, with 20, leads to the limit of a half-plane.
const std::vector<double> ratios{1,   1.05, 1.1, 1.15, 1.2, 1.25, 1.3, 1.35, 1.4, 1.45, 1.5, 1.6, 1.7, 1.8,
                                 1.9, 2,    2.1, 2.2,  2.4, 2.6,  2.8, 3,    3.2, 3.5,  3.8, 4,   4.5, 5,
                                 5.5, 6,    7,   8,    9,   10,   11,  12,   14,  16,   18,  20,  40};
const std::vector<double> speeds{0.01, 0.1, 0.3};

void write_ratio(fmt::ostream& out, double ratio) {
  const stoss::Disk smaller{.poisson = poisson}, larger{.poisson = poisson, .radius = ratio};
  const stoss::RefinableContact pair(stoss::disk(smaller), stoss::disk(larger));
  for (const stoss::Restitution& r :
       stoss::restitution_curve(pair, speeds, {.each = {.tolerance = tolerance, .absolute = 0.0}})) {
    const double reduced_mass = ratio * ratio / (1.0 + ratio * ratio);  // in that of the smaller disk
    out.print("{:.6g},{:.6g},{:.6f},{:.1e},{:.6f},{:.1e},", ratio, r.finest.speed, r.restitution.value,
              r.restitution.error, r.lost_fraction.value, r.lost_fraction.error);
    out.print("{:.6f},{:.6f},{:.6f},", r.finest.energy.lost_to_first, r.finest.energy.lost_to_second,
              (1.0 + r.restitution.value) * reduced_mass);
    out.print("{:.4f},{:.1e},{:.6f},{}\n", r.contact_time.value, r.contact_time.error, 1.0 / ratio, r.converged);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: stoss_pairs FILE\n");
    return 2;
  }
  try {
    auto out = fmt::output_file(argv[1]);
    out.print(
        "# Two disks of one material, nu = {}, tolerance {} of 1-eps^2; made by `make results`. R, m: smaller disk.\n",
        poisson, tolerance);
    out.print(
        "radius_ratio,speed[c],restitution,restitution_error,lost_fraction,lost_fraction_error,lost_to_smaller,"
        "lost_to_larger,impulse[mv],contact_time[R/c],contact_time_error,restitution_of_rods,converged\n");
    for (const double ratio : ratios) write_ratio(out, ratio);
  } catch (const std::exception& error) {
    fmt::print(stderr, "stoss_pairs: {}\n", error.what());
    return 1;
  }
  return 0;
}
