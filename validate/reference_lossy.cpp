// Reference values for lossy disks and spheres at a hard wall, and for pairs of them.
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "judgement.hpp"
#include "reference.hpp"
#include "restitution/ordered_jobs.hpp"
#include "runs.hpp"

namespace validate {
namespace {

constexpr int threads = 2;
constexpr int impacts = 48;
constexpr Finenesses finenesses{Fineness{80.0, 0.2, 2.4}, Fineness{113.0, 0.35, 1.3}, Fineness{160.0, 0.3, 1.8}};

double rounded(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return std::stod(text.data());
}

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

Runs compute(const Point& point) {
  const stoss::RefinableContact contact = make_contacts({point}).front();
  const double unit = 1.0 / stoss::time_scale(contact.at(0));
  return resolved_runs([&](double cutoff) { return contact.at(unit * cutoff, 1.0, {}); }, point.speed, finenesses);
}

void write_header(std::ostream& out) {
  out << "# Impacts of lossy spheres and disks at a hard wall, and of pairs of them in units of the first\n"
         "# (docs/theory/loss.md), more finely resolved than those of restitution(). Made by:\n"
         "# stoss_validate --make-lossy-reference FILE\n"
         "# Three runs at each point, with cutoffs 80, 113, 160 over the time scale of the contact, at least 128 "
         "nodes\n"
         "# and up to 2.4 times those of restitution(). Value: that of the last run; uncertainty: spread of the "
         "three.\n"
         "body,poisson,loss_time,against_poisson,against_radius,against_loss_time,speed,"
      << quantity_columns << '\n';
}

void write_place(std::ostream& out, const Point& point) {
  out << (point.sphere ? "sphere" : "disk") << ',' << point.poisson << ',' << point.loss_time << ',';
  if (point.against) out << point.against->poisson << ',' << point.against->radius << ',' << point.against->loss_time;
  out << (point.against ? "," : ",,,") << point.speed;
}

}  // namespace

void make_lossy_reference(const std::string& path) {
  std::ofstream file(path);
  write_header(file);
  const std::vector<Point> all = design();
  stoss::run_in_order<Runs>(
      all.size(), threads, [&](std::size_t i, const std::atomic<bool>&) { return compute(all[i]); },
      [&](std::size_t i, Runs&& runs) {
        write_place(file, all[i]);
        write_quantities(file, runs);
        std::cerr << "\rreference " << i + 1 << " of " << all.size() << std::flush;
      },
      {});
  std::cerr << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace validate
