// Reference values for balls on plates and disks on strips.
#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "plate_points.hpp"
#include "reference.hpp"
#include "restitution/lasting.hpp"
#include "runs.hpp"
#include "stoss/errors.hpp"

namespace validate {
namespace {

constexpr int impacts = 48, unseen_impacts = 96;

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

/// Others at random: every fifth a disk on a strip, four of ten bodies rigid, three of ten plates with two or three
/// layers, every fifth lossy.
std::vector<PlateCase> unseen_design() {
  constexpr unsigned seed = 46019;
  std::mt19937_64 random(seed);
  const auto share = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  const auto layer = [&share](double thinnest, double thickest) {
    stoss::Layer its;
    its.thickness = between(thinnest, thickest, share());
    its.poisson = poisson(share());
    its.young = between(0.1, 10.0, share());
    its.density = between(0.1, 10.0, share());
    return its;
  };
  std::vector<PlateCase> all;
  for (int i = 0; i < unseen_impacts; ++i) {
    PlateCase its;
    its.strip = share() < 0.2;
    its.rigid = share() < 0.4;
    its.poisson = poisson(share());
    const int below = share() < 0.3 ? (share() < 0.5 ? 1 : 2) : 0;
    its.layers = {layer(0.1, below == 0 ? 30.0 : 3.0)};
    const double first = its.layers.front().thickness;
    for (int k = 0; k < below; ++k) its.layers.push_back(layer(0.2 * first, 5.0 * first));
    if (share() < 0.2) {
      its.plate_loss_time = between(1e-3, 1.0, share());
      if (!its.rigid && share() < 0.5) its.loss_time = rounded("%.3g", 0.5 * its.plate_loss_time);
    }
    const double slower = std::min(1.0, std::sqrt(its.layers.front().young / its.layers.front().density));
    its.speed = rounded("%.3g", slower * between(1e-6, 0.3, share()));
    all.push_back(its);
  }
  return all;
}

/// How finely, and for how long a contact the plate is made.
struct PlateFineness {
  Fineness its;
  double stretch;  ///< over that of restitution()
};
using PlateFinenesses = std::array<PlateFineness, 3>;
constexpr PlateFinenesses seen_finenesses{PlateFineness{{12.0, 0.2, 2.0}, 1.5}, PlateFineness{{17.0, 0.3, 1.3}, 1.2},
                                          PlateFineness{{24.0, 0.25, 1.6}, 1.35}};
/// So much finer that their spread is small beside the errors that are judged.
constexpr PlateFinenesses unseen_finenesses{PlateFineness{{24.0, 0.2, 2.0}, 1.2},
                                            PlateFineness{{34.0, 0.25, 1.6}, 1.35},
                                            PlateFineness{{48.0, 0.25, 1.6}, 1.1}};

/// Ends what takes more than a few seconds of processor time.
class Patience {
 public:
  Patience() : end_(now() + most) {}
  void operator()() const {
    if (now() > end_) throw stoss::NotConverged("takes more than " + std::to_string(std::lround(most)) + " s");
  }

 private:
  static constexpr double most = 3.0;
  static double now() {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double end_;
};

/// Runs of the finenesses as far as there is patience for them, two at least; then the last of them again.
ImpactRuns resolved_runs(const PlateCase& its, const PlateFinenesses& finenesses, bool patient) {
  const stoss::Poll heed = patient ? stoss::Poll{} : stoss::Poll{Patience{}};
  const stoss::RefinableContact contact = contact_of(its);
  const auto shorter = [](const PlateFineness& one, const PlateFineness& other) { return one.stretch < other.stretch; };
  const double most = std::max_element(finenesses.begin(), finenesses.end(), shorter)->stretch;
  const double start = contact.stretch(its.speed), longest = most * stoss::duration_margin * start;
  const double highest = contact.cutoff(contact.highest_level(longest)), fine = finenesses.back().its.cutoff;
  const double unit = std::min(1.0 / stoss::time_scale(contact.at(0)), highest / fine);
  const auto run_at = [&](double cutoff, double longer, const auto& compute) {
    double stretch = start;
    return stoss::retry_until_contact_ends(
        contact, unit * cutoff, its.speed, stretch, heed,
        [&](const stoss::Contact&) { return compute(contact.at(unit * cutoff, longer * stretch, heed)); });
  };
  const double first = 0.3125 * finenesses.front().its.cutoff;
  const double width = run_at(first, 1.0, [&](const stoss::Contact& met) {
                         return stoss::impact(met, its.speed, {.poll = heed});
                       }).max_half_width;
  ImpactRuns runs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto& [fineness, longer] = finenesses[i];
    try {
      runs[i] = run_at(fineness.cutoff, longer, [&](const stoss::Contact& met) {
        return stoss::impact(met, its.speed, {.resolution = finer(met, its.speed, fineness, width), .poll = heed});
      });
    } catch (const stoss::NotConverged&) {
      if (patient || i < 2) throw;
      runs[i] = runs[i - 1];
    }
  }
  return runs;
}

std::string place_of(const PlateCase& its) {
  std::ostringstream place;
  place << (its.strip ? "disk" : "sphere") << ',' << its.rigid << ',' << its.poisson << ',' << its.loss_time << ','
        << text_of(its.layers) << ',' << its.plate_loss_time << ',' << its.speed;
  return place.str();
}

std::string header(const std::string& option, const std::string& cutoffs, const std::string& stretches) {
  return "# Impacts of spheres on plates and of disks on strips, in units of the body, more finely resolved than "
         "those\n"
         "# of restitution() and with a plate for a longer time. Made by: stoss_validate " +
         option +
         " FILE\n"
         "# Three runs at each point, with cutoffs " +
         cutoffs +
         " over the time scale of the contact, or less where a plate has more "
         "waves\n"
         "# than are computed, at least 128 nodes, "
         "and\n"
         "# plates for " +
         stretches +
         " times as long a contact. Value: that of the last run; uncertainty: spread of "
         "the three.\n"
         "# layers: thickness:nu:E:rho of each, downwards; left out: balls that stay longer than is computed.\n"
         "body,rigid_body,poisson,loss_time,layers,plate_loss_time,speed," +
         quantity_columns + '\n';
}

void write_runs(const std::string& path, const std::string& header, const std::vector<PlateCase>& all,
                const PlateFinenesses& finenesses, bool patient) {
  std::vector<std::string> places;
  for (const PlateCase& its : all) places.push_back(place_of(its));
  write_reference(path, header, places, [&](std::size_t i) { return resolved_runs(all[i], finenesses, patient); });
}

}  // namespace

void make_plate_reference(const std::string& path) {
  write_runs(path, header("--make-plate-reference", "12, 17, 24", "1.5, 1.2 and 1.35"), design(), seen_finenesses,
             true);
}

void make_unseen_plate_reference(const std::string& path) {
  write_runs(path, header("--make-unseen-plate-reference", "24, 34, 48", "1.2, 1.35 and 1.1"), unseen_design(),
             unseen_finenesses, false);
}

}  // namespace validate
