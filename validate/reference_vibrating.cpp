// Reference values for disks and spheres that vibrate, at a hard wall and in pairs.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "judgement.hpp"
#include "reference.hpp"
#include "runs.hpp"

namespace validate {
namespace {

constexpr int impacts = 112;
constexpr Finenesses finenesses{Fineness{80.0, 0.2, 1.8}, Fineness{113.0, 0.35, 1.1}, Fineness{160.0, 0.3, 1.3}};

/// Point i of an additive sequence in seven dimensions, with the generalised golden ratio.
double spread(int i, int dimension) {
  constexpr double ratio = 1.0969815577985598;  // x⁸ = x + 1
  const double step = 0.5 + (i + 1) * std::pow(ratio, -(dimension + 1));
  return step - std::floor(step);
}

/// Disks and spheres at the wall, and pairs of them, in turn: ν from −0.5 to 0.9 and from 0 to 0.45; speeds from 1e-3
/// to 0.3, temperatures from 1e-3 to 1 and highest frequencies from 4 to 20, evenly on the logarithmic scale; of the
/// second body radius and modulus within a factor of 2.
std::vector<Point> design() {
  std::vector<Point> all;
  for (int i = 0; i < impacts; ++i) {
    Point point;
    point.sphere = i % 2 == 1;
    const auto poisson = [&](double x) { return rounded("%.2f", point.sphere ? 0.45 * x : -0.5 + 1.4 * x); };
    point.poisson = poisson(spread(i, 3));
    point.speed = rounded("%.3e", 1e-3 * std::pow(300.0, spread(i, 0)));
    point.temperature = rounded("%.3g", 1e-3 * std::pow(1e3, spread(i, 1)));
    point.highest = rounded("%.3g", 4.0 * std::pow(5.0, spread(i, 2)));
    point.sample = i;
    if (i % 4 >= 2) {
      point.against = stoss::Disk{.poisson = poisson(spread(i, 4)),
                                  .radius = rounded("%.3g", 0.5 * std::pow(4.0, spread(i, 5))),
                                  .young = rounded("%.3g", 0.5 * std::pow(4.0, spread(i, 6)))};
    }
    all.push_back(point);
  }
  return all;
}

ReferencePoint computed(const Point& point) {
  std::ostringstream place;
  place << (point.sphere ? "sphere" : "disk") << ',' << point.poisson << ',';
  if (point.against) place << point.against->poisson << ',' << point.against->radius << ',' << point.against->young;
  place << (point.against ? "," : ",,,") << point.speed << ',' << point.temperature << ',' << point.highest;
  const stoss::RefinableContact contact = make_contacts({point}).front();
  const double unit = 1.0 / stoss::time_scale(contact.at(0));
  return {place.str(), point.speed, [contact, unit](double cutoff) { return contact.at(unit * cutoff, 1.0, {}); },
          vibration_of(point, contact)};
}

std::string header() {
  return "# Impacts of vibrating disks and spheres at a hard wall, and of pairs of them in units of the first, more "
         "finely\n"
         "# resolved than those of restitution(). Made by: stoss_validate --make-vibrating-reference FILE\n"
         "# Row k, from 0, is sample k with seed 0 of the ensemble of its temperature and highest frequency. Three "
         "runs\n"
         "# at each point, with cutoffs 80, 113, 160 over the time scale of the contact, steps and nodes as in\n"
         "# reference_spheres.csv. Value: that of the last run; uncertainty: spread of the three.\n"
         "body,poisson,against_poisson,against_radius,against_young,speed,temperature,highest," +
         quantity_columns + '\n';
}

}  // namespace

void make_vibrating_reference(const std::string& path) {
  std::vector<ReferencePoint> points;
  for (const Point& point : design()) points.push_back(computed(point));
  write_reference(path, header(), points, finenesses);
}

}  // namespace validate
