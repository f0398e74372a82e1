// Reference values for spheres at a hard wall.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "reference.hpp"
#include "runs.hpp"
#include "stoss/bodies/sphere.hpp"

namespace validate {
namespace {

constexpr int spheres = 64;
constexpr Finenesses finenesses{Fineness{80.0, 0.2, 1.8}, Fineness{113.0, 0.35, 1.1}, Fineness{160.0, 0.3, 1.3}};

/// ν from −0.5 to 0.49 and speeds from 1e-6 to 0.5, evenly on the logarithmic scale, by an additive sequence.
std::vector<ReferencePoint> design() {
  constexpr double ratio = 1.3247179572447460;  // x³ = x + 1
  const auto spread = [](double x) { return x - std::floor(x); };
  std::vector<ReferencePoint> points;
  for (int i = 1; i <= spheres; ++i) {
    const double poisson = rounded("%.3f", -0.5 + 0.99 * spread(0.5 + i / ratio));
    const double speed = rounded("%.3e", 1e-6 * std::pow(5e5, spread(0.5 + i / (ratio * ratio))));
    std::ostringstream place;
    place << poisson << ',' << speed;
    points.push_back(
        {place.str(), speed, [poisson](double cutoff) { return stoss::contact(stoss::sphere(poisson, cutoff)); }});
  }
  return points;
}

std::string header() {
  return "# Impacts of a sphere at a hard wall, dimensionless (docs/theory/spheres.md), more finely resolved than "
         "those of\n"
         "# restitution(). Made by: stoss_validate --make-sphere-reference FILE\n"
         "# Three runs at each point, with cutoffs 80, 113, 160, steps and nodes as in reference.csv. Value: that of "
         "the\n"
         "# last run; uncertainty: spread of the three.\n"
         "poisson,speed," +
         quantity_columns + '\n';
}

}  // namespace

void make_sphere_reference(const std::string& path) { write_reference(path, header(), design(), finenesses); }

}  // namespace validate
