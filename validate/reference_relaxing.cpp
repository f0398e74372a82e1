// Reference values for disks and spheres of materials that relax: at a hard wall, in pairs and on half-spaces.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "judgement.hpp"
#include "reference.hpp"
#include "runs.hpp"
#include "stoss/encounter/relaxing.hpp"

namespace validate {
namespace {

constexpr int impacts = 72;
constexpr Finenesses finenesses{Fineness{80.0, 0.2, 2.4}, Fineness{113.0, 0.35, 1.3}, Fineness{160.0, 0.3, 1.8}};
constexpr Finenesses on_half_spaces{Fineness{12.0, 0.2, 2.4}, Fineness{17.0, 0.35, 1.3}, Fineness{24.0, 0.3, 1.8}};

/// Point i of an additive sequence in six dimensions, with the generalised golden ratio.
double spread(int i, int dimension) {
  constexpr double ratio = 1.1127756842787055;  // x⁷ = x + 1
  const double step = 0.5 + (i + 1) * std::pow(ratio, -(dimension + 1));
  return step - std::floor(step);
}

/// One to five terms over up to four decades, of 10⁻⁴ to 95 % of the modulus in sum: tan δ up to some 3.
stoss::Relaxation drawn(int terms, double share, double time) {
  stoss::Relaxation relaxation;
  const double all = share < 0.5 ? 1e-4 * std::pow(3e3, 2.0 * share) : 0.3 + 1.3 * (share - 0.5);
  for (int j = 0; j < terms; ++j) {
    const double middle = 1e-2 * std::pow(1e4, time), apart = j - 0.5 * (terms - 1);
    relaxation.terms.push_back({rounded("%.3g", all / terms), rounded("%.3g", middle * std::pow(6.0, apart))});
  }
  return relaxation;
}

/// Spheres and disks in turn, every third one at another, every fourth on a half-space, of which two in three relax
/// too; ν from −0.4 to 0.48, times from 10⁻² to 10² R/c, speeds from 1e-7 to 0.3.
std::vector<Point> design() {
  std::vector<Point> all;
  const auto poisson = [](double x) { return rounded("%.2f", -0.4 + 0.88 * x); };
  for (int i = 0; i < impacts; ++i) {
    Point point;
    point.sphere = i % 2 == 0;
    point.poisson = poisson(spread(i, 0));
    point.relaxation = drawn(1 + i % 5, spread(i, 1), spread(i, 2));
    point.speed = rounded("%.3e", 1e-7 * std::pow(3e6, spread(i, 3)));
    point.half_space = i % 8 > 5;
    if (i % 3 == 2 || point.half_space) {
      point.against = stoss::Disk{.poisson = poisson(spread(i, 4))};
      if (!point.half_space) point.against->radius = rounded("%.3g", std::pow(3.0, 2.0 * spread(i, 5) - 1.0));
      if (i % 4 != 3) point.against_relaxation = drawn(1 + i % 3, spread(i, 5), spread(i, 1));
    }
    all.push_back(point);
  }
  return all;
}

ReferencePoint computed(const Point& point) {
  std::ostringstream place;
  place << (point.sphere ? "sphere" : "disk") << ',' << point.half_space << ',' << point.poisson << ','
        << text_of(point.relaxation) << ',';
  if (point.against) place << point.against->poisson << ',' << point.against->radius;
  place << (point.against ? "," : ",,") << text_of(point.against_relaxation) << ',' << point.speed;
  const stoss::RefinableContact contact = make_contacts({point}).front();
  const double unit = 1.0 / stoss::time_scale(contact.at(0));
  if (!point.half_space) {
    return {place.str(), point.speed, [contact, unit](double cutoff) { return contact.at(unit * cutoff, 1.0, {}); }};
  }
  const Makers makers = makers_of(point);
  return {place.str(), point.speed, [makers, unit, speed = point.speed](double cutoff) {
            return stoss::contact(makers.first, makers.second, unit * cutoff, speed);
          }};
}

std::string header() {
  return "# Impacts of spheres and disks of materials that relax at a hard wall, at another and on half-spaces, in "
         "units\n"
         "# of the first (docs/theory/loss.md), more finely resolved than those of restitution(). Terms as\n"
         "# share:time+..., times in R/c of each body. Made by: stoss_validate --make-relaxing-reference FILE\n"
         "# Three runs at each point, with cutoffs 80, 113, 160 over the time scale of the contact (12, 17, 24 on\n"
         "# half-spaces), at least 128 nodes and up to 2.4 times those of restitution(). Value: that of the last run;\n"
         "# uncertainty: spread of the three.\n"
         "body,half_space,poisson,terms,against_poisson,against_radius,against_terms,speed," +
         quantity_columns + '\n';
}

}  // namespace

void make_relaxing_reference(const std::string& path) {
  std::vector<ReferencePoint> points;
  std::vector<std::string> places;
  const std::vector<Point> all = design();
  for (const Point& point : all) {
    points.push_back(computed(point));
    places.push_back(points.back().place);
  }
  write_reference(path, header(), places, [&](std::size_t i) {
    return resolved_runs(points[i], all[i].half_space ? on_half_spaces : finenesses);
  });
}

}  // namespace validate
