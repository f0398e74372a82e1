// Reference values for oblique impacts with friction.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "contact/along.hpp"
#include "impact/recommended.hpp"
#include "oblique_points.hpp"
#include "reference.hpp"
#include "runs.hpp"

namespace validate {
namespace {

constexpr int impacts = 70;

/// What meets, in turn.
struct Meeting {
  const char *body, *against;
  bool alike = false;  // of one kind and size
};
constexpr std::array meetings{Meeting{"disk", "wall"},        Meeting{"disk", "body"},   Meeting{"disk", "body", true},
                              Meeting{"disk", "half-space"},  Meeting{"sphere", "wall"}, Meeting{"sphere", "body"},
                              Meeting{"sphere", "half-space"}};

/// Point i of an additive sequence in eight dimensions, with the generalised golden ratio.
double spread(int i, int dimension) {
  constexpr double ratio = 1.0850702454914508;  // x⁹ = x + 1
  const double step = 0.5 + (i + 1) * std::pow(ratio, -(dimension + 1));
  return step - std::floor(step);
}

/// Evenly on the logarithmic scale.
double between(double low, double high, double share) { return rounded("%.3g", low * std::pow(high / low, share)); }

/// The maximum of friction: sliding must be stable, also in the contact of a disk (docs/theory/oblique.md).
double most_friction(const ObliqueCase& its) {
  constexpr double most = 2.0, stable = 0.7;
  return std::min(most, stable * stoss::stable_friction(stoss::contacts_along(contact_of(its).at(0), {})));
}

/// ν of disks from −0.4 to 0.8 and of spheres from −0.2 to 0.45, speeds from 1e-4 to 0.3, friction from 0.02 to 2,
/// s/μv from 0.1 to 8; radius and modulus of the second within a factor of 3. Every third slides by its spin, every
/// eighth is lossy.
std::vector<ObliqueCase> design() {
  std::vector<ObliqueCase> all;
  for (int i = 0; i < impacts; ++i) {
    const Meeting& meeting = meetings[static_cast<std::size_t>(i) % meetings.size()];
    ObliqueCase its;
    its.body = meeting.body;
    its.against = meeting.against;
    const bool disk = its.body == "disk";
    const auto poisson = [&](double x) { return rounded("%.2f", disk ? -0.4 + 1.2 * x : -0.2 + 0.65 * x); };
    its.poisson = its.second.poisson = poisson(spread(i, 0));
    if (its.against != "wall" && !meeting.alike) {
      its.second.poisson = poisson(spread(i, 1));
      its.second.young = between(1.0 / 3.0, 3.0, spread(i, 2));
      if (its.against == "body") its.second.radius = between(1.0 / 3.0, 3.0, spread(i, 3));
    }
    if (i % 8 == 7) its.loss_time = between(1e-3, 1.0, spread(i, 3));
    its.speed = between(1e-4, 0.3, spread(i, 4));
    its.before.friction = between(0.02, most_friction(its), spread(i, 5));
    const double sliding = rounded("%.4g", between(0.1, 8.0, spread(i, 6)) * its.before.friction * its.speed);
    (i % 3 == 2 ? its.before.spin : its.before.tangential) = sliding;
    all.push_back(its);
  }
  return all;
}

struct ObliqueFineness {
  double cutoff;  ///< over the time scale of the contact
  double step;    ///< times the cutoff
  double nodes;
};
using ObliqueFinenesses = std::array<ObliqueFineness, 3>;

constexpr ObliqueFinenesses of_disks{ObliqueFineness{90.0, 0.25, 72.0}, {128.0, 0.2, 84.0}, {181.0, 0.25, 96.0}};
constexpr ObliqueFinenesses of_pairs{ObliqueFineness{64.0, 0.25, 72.0}, {90.0, 0.2, 84.0}, {128.0, 0.25, 96.0}};
constexpr ObliqueFinenesses on_half_planes{ObliqueFineness{24.0, 0.25, 72.0}, {34.0, 0.2, 84.0}, {48.0, 0.25, 96.0}};
constexpr ObliqueFinenesses of_spheres{ObliqueFineness{32.0, 0.35, 80.0}, {45.0, 0.5, 112.0}, {64.0, 0.4, 144.0}};
constexpr ObliqueFinenesses on_half_spaces{ObliqueFineness{8.0, 0.35, 80.0}, {11.0, 0.5, 96.0}, {16.0, 0.4, 128.0}};

const ObliqueFinenesses& finenesses_of(const ObliqueCase& its) {
  if (its.body == "sphere") return its.against == "half-space" ? on_half_spaces : of_spheres;
  if (its.against == "half-space") return on_half_planes;
  return its.against == "body" ? of_pairs : of_disks;
}

using Runs = std::array<stoss::ObliqueImpact, 3>;

Runs resolved_runs(const ObliqueCase& its) {
  const stoss::RefinableContact contact = contact_of(its);
  const double unit = 1.0 / stoss::time_scale(contact.at(0)), stretch = contact.stretch(its.speed);
  const ObliqueFinenesses& finenesses = finenesses_of(its);
  double width =
      stoss::oblique_impact(contact.at(0.3 * unit * finenesses[0].cutoff, stretch, {}), its.speed, its.before)
          .normal.max_half_width;
  Runs runs;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const stoss::Contact& resolved = contact.at(unit * finenesses[k].cutoff, stretch, {});
    stoss::Resolution resolution = stoss::refined_resolution(resolved, its.speed, width);
    resolution.nodes = static_cast<int>(finenesses[k].nodes);
    resolution.step = std::min(finenesses[k].step / resolved.cutoff, resolved.stable_step);
    runs[k] = stoss::oblique_impact(resolved, its.speed, its.before, {.resolution = resolution});
  }
  return runs;
}

void write_quantity(std::ostream& out, const Runs& runs, double stoss::ObliqueImpact::*quantity) {
  double low = runs.back().*quantity, high = low;
  for (const stoss::ObliqueImpact& run : runs) {
    low = std::min(low, run.*quantity);
    high = std::max(high, run.*quantity);
  }
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), ",%.8g,%.1e", runs.back().*quantity, high - low);
  out << text.data();
}

}  // namespace

void make_oblique_reference(const std::string& path) {
  std::ofstream file(path);
  file << "# Oblique impacts of disks and spheres with friction, in units of the first body (docs/theory/oblique.md),\n"
          "# more finely resolved than those of oblique_restitution(). Made by: stoss_validate\n"
          "# --make-oblique-reference FILE\n"
          "# Three runs at each point, of which cutoff, step and points differ by other ratios (validate/\n"
          "# reference_oblique.cpp). Value: that of the last run; uncertainty: spread of the three.\n"
          "body,against,poisson,loss_time,against_poisson,against_radius,against_young,speed,tangential,spin,friction,"
          "restitution,restitution_uncertainty,sliding_after,sliding_after_uncertainty\n";
  const std::vector<ObliqueCase> all = design();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ObliqueCase& its = all[i];
    const Runs runs = resolved_runs(its);
    file << its.body << ',' << its.against << ',' << its.poisson << ',' << its.loss_time << ',' << its.second.poisson
         << ',' << its.second.radius << ',' << its.second.young << ',' << its.speed << ',' << its.before.tangential
         << ',' << its.before.spin << ',' << its.before.friction;
    write_quantity(file, runs, &stoss::ObliqueImpact::restitution);
    write_quantity(file, runs, &stoss::ObliqueImpact::sliding_after);
    file << std::endl;  // one may look on
    std::cerr << "\rreference " << i + 1 << " of " << all.size() << std::flush;
  }
  std::cerr << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace validate
