// Reference values: single impacts, resolved far more finely than those of restitution(), and their spread.
#include "reference.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "restitution/ordered_jobs.hpp"
#include "runs.hpp"
#include "stoss/bodies/disk.hpp"

namespace validate {
namespace {

constexpr int threads = 2;
constexpr std::array poisson_numbers{-0.9, -0.63, -0.27, 0.07, 0.33, 0.46, 0.61, 0.79, 0.91, 0.98};
constexpr int speeds_each = 9;

constexpr int unseen_points = 64;

struct Place {
  double poisson;
  double speed;
};

/// Rounded to what the file holds: that is what is computed.
double rounded(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return std::stod(text.data());
}

/// Every Poisson number has nine speeds, a factor of 4.4 apart and shifted against those of the others: ninety speeds,
/// no two alike, evenly from 1e-6 to 0.5 on the logarithmic scale.
std::vector<Place> design() {
  constexpr int columns = poisson_numbers.size();
  constexpr int shift = 3;  // has no factor in common with the number of columns
  constexpr double slowest = 1e-6, fastest = 0.5;
  std::vector<Place> places;
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < speeds_each; ++k) {
      const double rank = static_cast<double>(columns * k + (shift * i) % columns) / (columns * speeds_each - 1);
      const double speed = slowest * std::pow(fastest / slowest, rank);
      places.push_back({poisson_numbers[static_cast<std::size_t>(i)], rounded("%.3e", speed)});
    }
  }
  return places;
}

/// Point i of an additive sequence in two dimensions with the generalised golden ratio, which fills the square evenly:
/// −0.93 < ν < 0.99, 1e-6 < v < 0.5.
std::vector<Place> unseen_design() {
  constexpr double ratio = 1.324717957244746;  // x³ = x + 1
  constexpr double lowest = -0.93, highest = 0.99, slowest = 1e-6, fastest = 0.5;
  const auto spread = [](double x) { return x - std::floor(x); };
  std::vector<Place> places;
  for (int i = 1; i <= unseen_points; ++i) {
    const double across = spread(0.5 + i / ratio), along = spread(0.5 + i / (ratio * ratio));
    places.push_back({rounded("%.3f", lowest + (highest - lowest) * across),
                      rounded("%.3e", slowest * std::pow(fastest / slowest, along))});
  }
  return places;
}

/// The three runs differ in the cutoff, and in step and node spacing by other ratios than in the cutoff: errors of
/// each kind show in their spread.
constexpr Finenesses finenesses{Fineness{200.0, 0.2, 1.8}, Fineness{283.0, 0.35, 1.1}, Fineness{400.0, 0.3, 1.3}};

Runs compute(const Place& place) {
  return resolved_runs([&](double cutoff) { return stoss::contact(stoss::disk(place.poisson, cutoff)); }, place.speed,
                       finenesses);
}

void write_row(std::ostream& out, const Place& place, const Runs& runs) {
  out << place.poisson << ',' << place.speed;
  write_quantities(out, runs);
}

void write_header(std::ostream& out, const std::string& what, const std::string& option) {
  out << "# " << what
      << ", dimensionless\n"
         "# (docs/theory/README.md), far more finely resolved than those of restitution().\n"
         "# Made by: stoss_validate "
      << option
      << " FILE\n"
         "# Three runs at each point, with cutoffs 200, 283, 400, steps 0.2, 0.35, 0.3 over the cutoff (or the body's "
         "stable\n"
         "# step), and 1.8, 1.1, 1.3 times the nodes of restitution() at that cutoff, at least 128. Value: that of the "
         "last\n"
         "# run; uncertainty: spread of the three (contact time: at least the last run's step).\n"
         "poisson,speed,"
      << quantity_columns << '\n';
}

void compute_all(std::ofstream& file, const std::string& path, const std::vector<Place>& places) {
  stoss::run_in_order<Runs>(
      places.size(), threads, [&](std::size_t i, const std::atomic<bool>&) { return compute(places[i]); },
      [&](std::size_t i, Runs&& runs) {
        write_row(file, places[i], runs);
        std::cerr << "\rreference " << i + 1 << " of " << places.size() << std::flush;
      },
      {});
  std::cerr << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace

void make_reference(const std::string& path) {
  std::ofstream file(path);
  write_header(file, "Impacts of a disk at a hard wall", "--make-reference");
  compute_all(file, path, design());
}

void make_unseen_reference(const std::string& path) {
  std::ofstream file(path);
  write_header(file, "Impacts of a disk at a hard wall to which no constant was fitted", "--make-unseen-reference");
  compute_all(file, path, unseen_design());
}

}  // namespace validate
