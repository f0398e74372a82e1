// Reference values: single impacts, resolved far more finely than those of restitution(), and their spread.
#include "reference.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "impact/resolution.hpp"
#include "restitution/ordered_jobs.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/impact/impact.hpp"

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
struct Fineness {
  double cutoff;
  double step;   ///< times the cutoff
  double nodes;  ///< over those of restitution() at this cutoff
};
constexpr std::array finenesses{Fineness{200.0, 0.2, 1.8}, Fineness{283.0, 0.35, 1.1}, Fineness{400.0, 0.3, 1.3}};

stoss::Impact resolved(const Point& point, const Fineness& fineness, double half_width) {
  constexpr double fewest_nodes = 128.0;
  const stoss::Contact contact = stoss::contact(stoss::disk(point.poisson, fineness.cutoff));
  stoss::ImpactOptions options = stoss::refined_resolution(contact, point.speed, half_width);
  options.nodes = static_cast<int>(std::max(fewest_nodes, std::ceil(fineness.nodes * options.nodes.value())));
  options.step = std::min(fineness.step / fineness.cutoff, contact.stable_step);
  return stoss::impact(contact, point.speed, options);
}

using Runs = std::array<stoss::Impact, finenesses.size()>;

Runs compute(const Point& point) {
  const stoss::Impact coarse = stoss::impact(stoss::disk(point.poisson, 25.0), stoss::HardWall{}, point.speed);
  Runs runs;
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i] = resolved(point, finenesses[i], coarse.max_half_width);
  return runs;
}

/// The finest value and the spread of all.
void write_quantity(std::ostream& out, const Runs& runs, double stoss::Impact::*quantity, double least = 0.0) {
  double low = runs.back().*quantity, high = low;
  for (const stoss::Impact& run : runs) {
    low = std::min(low, run.*quantity);
    high = std::max(high, run.*quantity);
  }
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), ",%.8g,%.1e", runs.back().*quantity, std::max(high - low, least));
  out << text.data();
}

void write_row(std::ostream& out, const Point& point, const Runs& runs) {
  out << point.poisson << ',' << point.speed;
  write_quantity(out, runs, &stoss::Impact::lost_fraction);
  write_quantity(out, runs, &stoss::Impact::contact_time,
                 runs.back().step);  // noticed and lost within half a step each
  write_quantity(out, runs, &stoss::Impact::max_force);
  write_quantity(out, runs, &stoss::Impact::max_compression);
  out << std::endl;  // one may look on
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
         "poisson,speed,lost_fraction,uncertainty,contact_time,contact_time_uncertainty,max_force,max_force_"
         "uncertainty,"
         "max_compression,max_compression_uncertainty\n";
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
