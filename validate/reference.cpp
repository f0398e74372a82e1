// Reference values: single impacts, resolved far more finely than those of restitution(), and their spread.
#include "reference.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "runs.hpp"
#include "stoss/bodies/disk.hpp"

namespace validate {
namespace {

constexpr std::array poisson_numbers{-0.9, -0.63, -0.27, 0.07, 0.33, 0.46, 0.61, 0.79, 0.91, 0.98};
constexpr int speeds_each = 9;

constexpr int unseen_points = 64;

ReferencePoint point(double poisson, double speed) {
  std::ostringstream place;
  place << poisson << ',' << speed;
  return {place.str(), speed, [poisson](double cutoff) { return stoss::contact(stoss::disk(poisson, cutoff)); }};
}

/// Every Poisson's ratio has nine speeds, a factor of 4.4 apart and shifted against those of the others: ninety speeds,
/// no two alike, evenly from 1e-6 to 0.5 on the logarithmic scale.
std::vector<ReferencePoint> design() {
  constexpr int columns = poisson_numbers.size();
  constexpr int shift = 3;  // has no factor in common with the number of columns
  constexpr double slowest = 1e-6, fastest = 0.5;
  std::vector<ReferencePoint> points;
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < speeds_each; ++k) {
      const double rank = static_cast<double>(columns * k + (shift * i) % columns) / (columns * speeds_each - 1);
      const double speed = slowest * std::pow(fastest / slowest, rank);
      points.push_back(point(poisson_numbers[static_cast<std::size_t>(i)], rounded("%.3e", speed)));
    }
  }
  return points;
}

/// Point i of an additive sequence in two dimensions with the generalised golden ratio, which fills the square evenly:
/// −0.93 < ν < 0.99, 1e-6 < v < 0.5.
std::vector<ReferencePoint> unseen_design() {
  constexpr double ratio = 1.324717957244746;  // x³ = x + 1
  constexpr double lowest = -0.93, highest = 0.99, slowest = 1e-6, fastest = 0.5;
  const auto spread = [](double x) { return x - std::floor(x); };
  std::vector<ReferencePoint> points;
  for (int i = 1; i <= unseen_points; ++i) {
    const double across = spread(0.5 + i / ratio), along = spread(0.5 + i / (ratio * ratio));
    points.push_back(point(rounded("%.3f", lowest + (highest - lowest) * across),
                           rounded("%.3e", slowest * std::pow(fastest / slowest, along))));
  }
  return points;
}

/// The three runs differ in the cutoff, and in step and node spacing by other ratios than in the cutoff: errors of
/// each kind show in their spread.
constexpr Finenesses finenesses{Fineness{200.0, 0.2, 1.8}, Fineness{283.0, 0.35, 1.1}, Fineness{400.0, 0.3, 1.3}};

std::string header(const std::string& what, const std::string& option) {
  return "# " + what +
         ", dimensionless\n"
         "# (docs/theory/README.md), far more finely resolved than those of restitution().\n"
         "# Made by: stoss_validate " +
         option +
         " FILE\n"
         "# Three runs at each point, with cutoffs 200, 283, 400, steps 0.2, 0.35, 0.3 over the cutoff (or the body's "
         "stable\n"
         "# step), and 1.8, 1.1, 1.3 times the nodes of restitution() at that cutoff, at least 128. Value: that of the "
         "last\n"
         "# run; uncertainty: spread of the three (contact time: at least the last run's step).\n"
         "poisson,speed," +
         quantity_columns + "\n";
}

}  // namespace

void make_reference(const std::string& path) {
  write_reference(path, header("Impacts of a disk at a hard wall", "--make-reference"), design(), finenesses);
}

void make_unseen_reference(const std::string& path) {
  const std::string what = "Impacts of a disk at a hard wall to which no constant was fitted";
  write_reference(path, header(what, "--make-unseen-reference"), unseen_design(), finenesses);
}

}  // namespace validate
