// Do the errors of rows hold? stoss_validate_rows COUNT > docs/results/rows_validation.csv
//
// Random rows of two to five spheres or disks, alike or of their own radii and materials, some with gaps of 0.01 to 100
// R, a wall on the right, or two that move; judged by the motion at the cutoff 91, where it agrees with that at 64 to
// 2e-5 of the speed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"
#include "stoss/row/row.hpp"

namespace {

using namespace stoss;

struct Case {
  Row row;
  std::vector<double> speeds;
  bool disks = false, alike = false;
};

class Cases {
 public:
  Case next() {
    Case made;
    const int count = 2 + static_cast<int>(share() * 3.999);
    made.disks = share() < 0.5, made.alike = share() < 0.3;
    const double poisson = 0.45 * share();
    for (int i = 0; i < count; ++i) {
      const double radius = ratio(0.4), young = ratio(0.5), density = ratio(0.4), own = 0.45 * share();
      const Sphere ball{.poisson = made.alike ? poisson : own,
                        .radius = made.alike ? 1.0 : radius,
                        .young = made.alike ? 1.0 : young,
                        .density = made.alike ? 1.0 : density};
      const Disk disk{.poisson = ball.poisson, .radius = ball.radius, .young = ball.young, .density = ball.density};
      made.row.kinds.push_back(made.disks ? stoss::disk(disk) : sphere(ball));
      made.row.bodies.push_back(static_cast<std::size_t>(i));
    }
    made.row.wall_after = share() < 0.25;
    const bool apart = share() < 0.3;
    for (int i = 0; apart && i < count - (made.row.wall_after ? 0 : 1); ++i) {
      made.row.gaps.push_back(share() < 0.5 ? 0.0 : std::pow(10.0, 4.0 * share() - 2.0));
    }
    const double speed = std::exp(std::log(1e-4) + share() * std::log(2e3));
    made.speeds.resize(static_cast<std::size_t>(count));
    made.speeds[0] = speed;
    if (share() < 0.3 && count > 2) made.speeds[1] = speed;
    return made;
  }

 private:
  double share() { return std::generate_canonical<double, 53>(random_); }
  double ratio(double most) { return std::exp(most * (2.0 * share() - 1.0)); }

  std::mt19937 random_{53};
};

double greatest_difference(const std::vector<double>& one, const std::vector<double>& other) {
  double greatest = 0.0;
  for (std::size_t b = 0; b < one.size(); ++b) greatest = std::max(greatest, std::abs(one[b] - other[b]));
  return greatest;
}

/// Prints a line for each tolerance; nothing where the reference is none.
void judge(const Case& of, int number) {
  constexpr double settled = 1e-5, sure = 2e-5, finer = 91.0, coarser = 64.0;
  const double speed = of.speeds[0];
  const RowImpact reference = row_impact(of.row, of.speeds, finer, {}, {.settled = settled});
  const RowImpact check = row_impact(of.row, of.speeds, coarser, {}, {.settled = settled});
  const double open = *std::max_element(reference.open.begin(), reference.open.end());
  if (open + greatest_difference(reference.velocities_after, check.velocities_after) > sure * speed) return;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const RowResult result = row(of.row, of.speeds, {.tolerance = tolerance});
    double worst = 0.0, error = 0.0, bar = 0.0;
    for (std::size_t b = 0; b < of.speeds.size(); ++b) {
      const Estimate& its = result.velocities_after[b];
      const double apart = std::abs(its.value - reference.velocities_after[b]);
      worst = std::max(worst, apart / (its.error + sure * speed));
      error = std::max(error, apart), bar = std::max(bar, its.error);
    }
    std::printf("%d,%s,%zu,%d,%d,%.4g,%g,%d,%.4g,%.3g,%.3g,%.3g\n", number, of.disks ? "disks" : "spheres",
                of.speeds.size(), of.alike ? 1 : 0, of.row.wall_after ? 1 : 0, speed, tolerance,
                result.converged ? 1 : 0, result.cutoffs.back(), error / speed, bar / speed, worst);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 100;
  std::printf("row,bodies,count,alike,wall,speed,tolerance,converged,cutoff,error,bar,worst\n");
  Cases cases;
  for (int number = 0; number < count; ++number) {
    const Case of = cases.next();
    try {
      judge(of, number);
    } catch (const NotConverged& error) {
      std::fprintf(stderr, "row %d: %s\n", number, error.what());
    }
  }
  return 0;
}
