// Reference values for spheres at a hard wall.
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference.hpp"
#include "restitution/ordered_jobs.hpp"
#include "runs.hpp"
#include "stoss/bodies/sphere.hpp"

namespace validate {
namespace {

constexpr int threads = 2;
constexpr int spheres = 64;
constexpr Finenesses finenesses{Fineness{80.0, 0.2, 1.8}, Fineness{113.0, 0.35, 1.1}, Fineness{160.0, 0.3, 1.3}};

struct Place {
  double poisson;
  double speed;
};

double rounded(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return std::stod(text.data());
}

/// ν from −0.5 to 0.49 and speeds from 1e-6 to 0.5, evenly on the logarithmic scale, by an additive sequence.
std::vector<Place> design() {
  constexpr double ratio = 1.3247179572447460;  // x³ = x + 1
  const auto spread = [](double x) { return x - std::floor(x); };
  std::vector<Place> places;
  for (int i = 1; i <= spheres; ++i) {
    places.push_back({rounded("%.3f", -0.5 + 0.99 * spread(0.5 + i / ratio)),
                      rounded("%.3e", 1e-6 * std::pow(5e5, spread(0.5 + i / (ratio * ratio))))});
  }
  return places;
}

Runs compute(const Place& place) {
  return resolved_runs([&](double cutoff) { return stoss::contact(stoss::sphere(place.poisson, cutoff)); }, place.speed,
                       finenesses);
}

void write_header(std::ostream& out) {
  out << "# Impacts of a sphere at a hard wall, dimensionless (docs/theory/spheres.md), more finely resolved than "
         "those "
         "of\n"
         "# restitution(). Made by: stoss_validate --make-sphere-reference FILE\n"
         "# Three runs at each point, with cutoffs 80, 113, 160, steps and nodes as in reference.csv. Value: that of "
         "the\n"
         "# last run; uncertainty: spread of the three.\n"
         "poisson,speed,"
      << quantity_columns << '\n';
}

}  // namespace

void make_sphere_reference(const std::string& path) {
  std::ofstream file(path);
  write_header(file);
  const std::vector<Place> places = design();
  stoss::run_in_order<Runs>(
      places.size(), threads, [&](std::size_t i, const std::atomic<bool>&) { return compute(places[i]); },
      [&](std::size_t i, Runs&& runs) {
        file << places[i].poisson << ',' << places[i].speed;
        write_quantities(file, runs);
        std::cerr << "\rreference " << i + 1 << " of " << places.size() << std::flush;
      },
      {});
  std::cerr << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace validate
