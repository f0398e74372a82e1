// Reference values for balls on plates and disks on strips.
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "plate_points.hpp"
#include "reference.hpp"
#include "restitution/lasting.hpp"
#include "runs.hpp"

namespace validate {
namespace {

constexpr int impacts = 48;

/// Point i of an additive sequence, with the roots of the primes.
double spread(int i, int dimension) {
  constexpr std::array primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43};
  const double step = 0.5 + (i + 1) * std::sqrt(primes.at(static_cast<std::size_t>(dimension)));
  return step - std::floor(step);
}

/// Evenly on the logarithmic scale.
double between(double low, double high, double share) { return rounded("%.3g", low * std::pow(high / low, share)); }

double poisson(double share) { return 0.0 + rounded("%.2f", -0.2 + 0.69 * share); }  // not −0

/// Of the plate, whose further layers have 0.2 to 5 times the thickness of the first.
std::vector<stoss::Layer> layers(int i, int count) {
  std::vector<stoss::Layer> all{{between(0.05, count == 1 ? 50.0 : 3.0, spread(i, 0)), poisson(spread(i, 1)),
                                 between(0.1, 10.0, spread(i, 2)), between(0.1, 10.0, spread(i, 3))}};
  for (int below = 1; below < count; ++below) {
    const int at = 3 * below + 3;
    all.push_back({between(0.2 * all.front().thickness, 5.0 * all.front().thickness, spread(i, at + 2)),
                   poisson(spread(i, at + 2 + below)), between(0.1, 10.0, spread(i, at)),
                   between(0.1, 10.0, spread(i, at + 1))});
  }
  return all;
}

/// Every fifth a disk on a strip; of the plates every third has two layers, or three. Every third ball is rigid; every
/// fourth impact is lossy. Speeds in c of the ball or of the plate, whichever is less.
std::vector<PlateCase> design() {
  std::vector<PlateCase> all;
  for (int i = 0; i < impacts; ++i) {
    PlateCase its;
    its.strip = i % 5 == 4;
    its.rigid = i % 3 == 1;
    its.poisson = poisson(spread(i, 4));
    const bool layered = !its.strip && i % 4 == 2;
    its.layers = layers(i, layered ? 2 + (i / 4) % 2 : 1);
    if (i % 4 == 3) {
      const double loss_time = between(1e-3, 1.0, spread(i, 12));
      its.plate_loss_time = loss_time;
      if (!its.rigid && i % 8 == 3) its.loss_time = rounded("%.3g", 0.5 * loss_time);
    }
    const double slower = std::min(1.0, std::sqrt(its.layers.front().young / its.layers.front().density));
    its.speed = rounded("%.3g", slower * 1e-6 * std::pow(3e5, spread(i, 5)));
    all.push_back(its);
  }
  return all;
}

/// How finely, and for how long a contact the plate is made.
struct PlateFineness {
  Fineness its;
  double stretch;  ///< over that of restitution()
};
constexpr std::array finenesses{PlateFineness{{12.0, 0.2, 2.0}, 1.5}, PlateFineness{{17.0, 0.3, 1.3}, 1.2},
                                PlateFineness{{24.0, 0.25, 1.6}, 1.35}};

ImpactRuns resolved_runs(const PlateCase& its) {
  const stoss::RefinableContact contact = contact_of(its);
  const double start = contact.stretch(its.speed), longest = finenesses.front().stretch * stoss::room_to_last * start;
  const double highest = contact.cutoff(contact.highest_level(longest)), fine = finenesses.back().its.cutoff;
  const double unit = std::min(1.0 / stoss::time_scale(contact.at(0)), highest / fine);
  const auto run_at = [&](double cutoff, double longer, const auto& compute) {
    double stretch = start;
    return stoss::to_its_end(contact, unit * cutoff, its.speed, stretch, {}, [&](const stoss::Contact&) {
      return compute(contact.at(unit * cutoff, longer * stretch, {}));
    });
  };
  const double first = 0.3125 * finenesses.front().its.cutoff;
  const double width =
      run_at(first, 1.0, [&](const stoss::Contact& met) { return stoss::impact(met, its.speed); }).max_half_width;
  ImpactRuns runs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto& [fineness, longer] = finenesses[i];
    runs[i] = run_at(fineness.cutoff, longer, [&](const stoss::Contact& met) {
      return stoss::impact(met, its.speed, {.resolution = finer(met, its.speed, fineness, width)});
    });
  }
  return runs;
}

std::string place_of(const PlateCase& its) {
  std::ostringstream place;
  place << (its.strip ? "disk" : "sphere") << ',' << its.rigid << ',' << its.poisson << ',' << its.loss_time << ','
        << text_of(its.layers) << ',' << its.plate_loss_time << ',' << its.speed;
  return place.str();
}

std::string header() {
  return "# Impacts of spheres on plates and of disks on strips, in units of the body, more finely resolved than "
         "those\n"
         "# of restitution() and with a plate for a longer time. Made by: stoss_validate --make-plate-reference FILE\n"
         "# Three runs at each point, with cutoffs 12, 17, 24 over the time scale of the contact, or less where a "
         "plate has more "
         "waves\n"
         "# than are computed, at least 128 nodes, "
         "and\n"
         "# plates for 1.5, 1.2 and 1.35 times as long a contact. Value: that of the last run; uncertainty: spread of "
         "the three.\n"
         "# layers: thickness:nu:E:rho of each, downwards; left out: balls that stay longer than is computed.\n"
         "body,rigid_body,poisson,loss_time,layers,plate_loss_time,speed," +
         quantity_columns + '\n';
}

}  // namespace

void make_plate_reference(const std::string& path) {
  std::vector<PlateCase> all = design();
  std::vector<std::string> places;
  for (const PlateCase& its : all) places.push_back(place_of(its));
  write_reference(path, header(), places, [&](std::size_t i) { return resolved_runs(all[i]); });
}

}  // namespace validate
