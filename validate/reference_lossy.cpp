// Reference values for lossy disks and spheres at a hard wall, and for pairs of them.
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
constexpr Finenesses finenesses{Fineness{80.0, 0.2, 2.4}, Fineness{113.0, 0.35, 1.3}, Fineness{160.0, 0.3, 1.8}};

/// Point i of an additive sequence in five dimensions, with the generalised golden ratio.
double spread(int i, int dimension) {
  constexpr double ratio = 1.1347241384015194;  // x⁶ = x + 1
  const double step = 0.5 + (i + 1) * std::pow(ratio, -(dimension + 1));
  return step - std::floor(step);
}

/// Spheres and disks in turn, every third one at another; ν from −0.4 to 0.48, η from 1e-4 to 100 and speeds from 1e-8
/// to 0.3, evenly on the logarithmic scale.
std::vector<Point> design() {
  std::vector<Point> all;
  const auto poisson = [](double x) { return rounded("%.2f", -0.4 + 0.88 * x); };
  const auto loss_time = [](double x) { return rounded("%.3g", 1e-4 * std::pow(1e6, x)); };
  for (int i = 0; i < impacts; ++i) {
    Point point;
    point.sphere = i % 2 == 0;
    point.poisson = poisson(spread(i, 0));
    point.loss_time = loss_time(spread(i, 1));
    point.speed = rounded("%.3e", 1e-8 * std::pow(3e7, spread(i, 2)));
    if (i % 3 == 2) {
      point.against = stoss::Disk{.poisson = poisson(spread(i, 3)),
                                  .radius = rounded("%.3g", std::pow(3.0, 2.0 * spread(i, 0) - 1.0)),
                                  .loss_time = loss_time(spread(i, 4))};
    }
    all.push_back(point);
  }
  return all;
}

ReferencePoint computed(const Point& point) {
  std::ostringstream place;
  place << (point.sphere ? "sphere" : "disk") << ',' << point.poisson << ',' << point.loss_time << ',';
  if (point.against) place << point.against->poisson << ',' << point.against->radius << ',' << point.against->loss_time;
  place << (point.against ? "," : ",,,") << point.speed;
  const stoss::RefinableContact contact = make_contacts({point}).front();
  const double unit = 1.0 / stoss::time_scale(contact.at(0));
  return {place.str(), point.speed, [contact, unit](double cutoff) { return contact.at(unit * cutoff, 1.0, {}); }};
}

std::string header() {
  return "# Impacts of lossy spheres and disks at a hard wall, and of pairs of them in units of the first\n"
         "# (docs/theory/loss.md), more finely resolved than those of restitution(). Made by:\n"
         "# stoss_validate --make-lossy-reference FILE\n"
         "# Three runs at each point, with cutoffs 80, 113, 160 over the time scale of the contact, at least 128 "
         "nodes\n"
         "# and up to 2.4 times those of restitution(). Value: that of the last run; uncertainty: spread of the "
         "three.\n"
         "body,poisson,loss_time,against_poisson,against_radius,against_loss_time,speed," +
         quantity_columns + '\n';
}

}  // namespace

void make_lossy_reference(const std::string& path) {
  std::vector<ReferencePoint> points;
  for (const Point& point : design()) points.push_back(computed(point));
  write_reference(path, header(), points, finenesses);
}

}  // namespace validate
