// Reference values for spheres on half-spaces and disks on half-planes.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "judgement.hpp"
#include "reference.hpp"
#include "runs.hpp"

namespace validate {
namespace {

constexpr int impacts = 48;
constexpr Finenesses finenesses{Fineness{12.0, 0.2, 2.0}, Fineness{17.0, 0.3, 1.3}, Fineness{24.0, 0.25, 1.6}};

/// Point i of an additive sequence in five dimensions, with the generalised golden ratio.
double spread(int i, int dimension) {
  constexpr double ratio = 1.1347241384015194;  // x⁶ = x + 1
  const double step = 0.5 + (i + 1) * std::pow(ratio, -(dimension + 1));
  return step - std::floor(step);
}

/// Three spheres and a disk in turn, every fifth body rigid; ν from −0.4 to 0.48, E and ρ of the half-space from 0.01
/// to 100 and from 0.1 to 10, speeds from 1e-6 to 0.5 in c of the body or of the half-space, whichever is less.
std::vector<Point> design() {
  std::vector<Point> all;
  const auto poisson = [](double x) { return rounded("%.2f", -0.4 + 0.88 * x); };
  for (int i = 0; i < impacts; ++i) {
    Point point;
    point.half_space = true;
    point.sphere = i % 4 != 3;
    point.rigid = i % 5 == 4;
    point.poisson = poisson(spread(i, 0));
    const double young = rounded("%.3g", std::pow(10.0, 4.0 * spread(i, 2) - 2.0));
    const double density = rounded("%.3g", std::pow(10.0, 2.0 * spread(i, 3) - 1.0));
    point.against = stoss::Disk{.poisson = poisson(spread(i, 1)), .young = young, .density = density};
    const double slower = std::min(1.0, std::sqrt(young / density));
    point.speed = rounded("%.3e", slower * 1e-6 * std::pow(5e5, spread(i, 4)));
    all.push_back(point);
  }
  return all;
}

ReferencePoint computed(const Point& point) {
  std::ostringstream place;
  place << (point.sphere ? "sphere" : "disk") << ',' << point.rigid << ',' << point.poisson << ','
        << point.against->poisson << ',' << point.against->young << ',' << point.against->density << ',' << point.speed;
  const Makers makers = makers_of(point);
  const double unit = 1.0 / stoss::time_scale(stoss::RefinableContact(makers.first, makers.second).at(0));
  return {place.str(), point.speed, [makers, unit, speed = point.speed](double cutoff) {
            return stoss::contact(makers.first, makers.second, unit * cutoff, speed);
          }};
}

std::string header() {
  return "# Impacts of spheres on half-spaces and of disks on half-planes, in units of the body\n"
         "# (docs/theory/half_space.md), more finely resolved than those of restitution() and with a half-space for a\n"
         "# longer time. Made by: stoss_validate --make-half-space-reference FILE\n"
         "# Three runs at each point, with cutoffs 12, 17, 24 over the time scale of the contact and at least 128 "
         "nodes.\n"
         "# Value: that of the last run; uncertainty: spread of the three.\n"
         "body,rigid_body,poisson,against_poisson,against_young,against_density,speed," +
         quantity_columns + '\n';
}

}  // namespace

void make_half_space_reference(const std::string& path) {
  std::vector<ReferencePoint> points;
  for (const Point& point : design()) points.push_back(computed(point));
  write_reference(path, header(), points, finenesses);
}

}  // namespace validate
