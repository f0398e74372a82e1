// Reference values: single impacts, resolved far more finely than those of restitution(), and their spread.
#include "reference.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "restitution/ordered_jobs.hpp"
#include "runs.hpp"
#include "stoss/bodies/disk.hpp"

namespace validate {
namespace {

constexpr int threads = 2;
constexpr std::array poisson_numbers{-0.9, -0.63, -0.27, 0.07, 0.33, 0.46, 0.61, 0.79, 0.91, 0.98};
constexpr int speeds_each = 9;

struct Point {
  double poisson;
  double speed;
};

/// Every Poisson number has nine speeds, a factor of 4.4 apart and shifted against those of the others: ninety speeds,
/// no two alike, evenly from 1e-6 to 0.5 on the logarithmic scale.
std::vector<Point> design() {
  constexpr int columns = poisson_numbers.size();
  constexpr int shift = 3;  // has no factor in common with the number of columns
  constexpr double slowest = 1e-6, fastest = 0.5;
  std::vector<Point> points;
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < speeds_each; ++k) {
      const double rank = static_cast<double>(columns * k + (shift * i) % columns) / (columns * speeds_each - 1);
      std::array<char, 32> text{};  // the file holds the very speed that was computed
      std::snprintf(text.data(), text.size(), "%.3e", slowest * std::pow(fastest / slowest, rank));
      points.push_back({poisson_numbers[static_cast<std::size_t>(i)], std::stod(text.data())});
    }
  }
  return points;
}

/// The three runs differ in the cutoff, and in step and node spacing by other ratios than in the cutoff: errors of
/// each kind show in their spread.
constexpr Finenesses finenesses{Fineness{200.0, 0.2, 1.8}, Fineness{283.0, 0.35, 1.1}, Fineness{400.0, 0.3, 1.3}};

Runs compute(const Point& point) {
  return resolved_runs([&](double cutoff) { return stoss::contact(stoss::disk(point.poisson, cutoff)); }, point.speed,
                       finenesses);
}

void write_row(std::ostream& out, const Point& point, const Runs& runs) {
  out << point.poisson << ',' << point.speed;
  write_quantities(out, runs);
}

void write_header(std::ostream& out) {
  out << "# Impacts of a disk at a hard wall, dimensionless (docs/theory/README.md), far more finely resolved than "
         "those of\n"
         "# restitution(). Made by: stoss_validate --make-reference FILE\n"
         "# Three runs at each point, with cutoffs 200, 283, 400, steps 0.2, 0.35, 0.3 over the cutoff (or the body's "
         "stable\n"
         "# step), and 1.8, 1.1, 1.3 times the nodes of restitution() at that cutoff, at least 128. Value: that of the "
         "last\n"
         "# run; uncertainty: spread of the three (contact time: at least the last run's step).\n"
         "poisson,speed,"
      << quantity_columns << '\n';
}

}  // namespace

void make_reference(const std::string& path) {
  std::ofstream file(path);
  write_header(file);
  const std::vector<Point> points = design();
  stoss::run_in_order<Runs>(
      points.size(), threads, [&](std::size_t i, const std::atomic<bool>&) { return compute(points[i]); },
      [&](std::size_t i, Runs&& runs) {
        write_row(file, points[i], runs);
        std::cerr << "\rreference " << i + 1 << " of " << points.size() << std::flush;
      },
      {});
  std::cerr << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace validate
