// Reference values for hollow spheres at a hard wall.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "reference.hpp"
#include "runs.hpp"
#include "stoss/bodies/hollow_sphere.hpp"

namespace validate {
namespace {

constexpr int shells = 48;
constexpr Finenesses finenesses{Fineness{113.0, 0.2, 1.8}, Fineness{160.0, 0.35, 1.1}, Fineness{226.0, 0.3, 1.3}};

/// Thicknesses from 0.5 to 0.03 and speeds from 1e-5 to 0.05, evenly on the logarithmic scale, and ν from 0 to 0.47, by
/// an additive sequence.
std::vector<ReferencePoint> design() {
  constexpr double ratio = 1.2207440846057596;  // x⁴ = x + 1
  const auto spread = [](double x) { return x - std::floor(x); };
  std::vector<ReferencePoint> points;
  for (int i = 1; i <= shells; ++i) {
    const double inner = rounded("%.3f", 1.0 - 0.5 * std::pow(0.06, spread(i / ratio)));
    const double poisson = rounded("%.3f", 0.47 * spread(i / (ratio * ratio)));
    const double speed = rounded("%.3e", 1e-5 * std::pow(5e3, spread(i / (ratio * ratio * ratio))));
    std::ostringstream place;
    place << poisson << ',' << inner << ',' << speed;
    points.push_back({place.str(), speed, [poisson, inner](double cutoff) {
                        return stoss::contact(stoss::hollow_sphere({.poisson = poisson, .inner = inner})(cutoff, {}));
                      }});
  }
  return points;
}

std::string header() {
  return "# Impacts of a hollow sphere at a hard wall, dimensionless (docs/theory/spheres.md), more finely resolved "
         "than\n"
         "# those of restitution(). Made by: stoss_validate --make-hollow-reference FILE\n"
         "# Three runs at each point, with cutoffs 113, 160, 226, steps and nodes as in reference.csv. Value: that of "
         "the\n"
         "# last run; uncertainty: spread of the three.\n"
         "poisson,inner,speed," +
         quantity_columns + '\n';
}

}  // namespace

void make_hollow_reference(const std::string& path) { write_reference(path, header(), design(), finenesses); }

}  // namespace validate
