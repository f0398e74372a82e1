#include "calibrate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "judgement.hpp"
#include "restitution/error_bar.hpp"
#include "restitution/ordered_jobs.hpp"
#include "sets.hpp"

namespace validate {
namespace {

using stoss::Restitution;

/// What runs ask of a constant.
struct Asked {
  double in_use = 0.0;
  std::vector<double> values{};
};

/// By the name of the constant.
using Calibration = std::map<std::string, Asked>;

std::optional<stoss::Estimate> reference_of(const Point& point, stoss::Estimate Restitution::*estimate) {
  const std::array<std::pair<stoss::Estimate Restitution::*, Quantity>, 5> all{
      {{&Restitution::lost_fraction, lost_fraction},
       {&Restitution::contact_time, contact_time},
       {&Restitution::impulse_time, impulse_time},
       {&Restitution::max_force, max_force},
       {&Restitution::max_compression, max_compression}}};
  for (const auto& [its, quantity] : all) {
    if (its == estimate) return point.reference[quantity];
  }
  return std::nullopt;
}

/// Of one point, from its third run on.
void take(const Point& point, const stoss::Contact& contact, Restitution result, Calibration& all) {
  constexpr std::size_t fewest = 3;
  const std::vector<stoss::Run> runs = result.runs;
  for (std::size_t count = fewest; count <= runs.size(); ++count) {
    result.runs.assign(runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(count));
    for (const stoss::Bar& bar : stoss::error_bars(contact, point.speed, result)) {
      const std::optional<stoss::Estimate> reference = reference_of(point, bar.estimate);
      const stoss::Term& term = bar.greatest();
      if (!reference || term.constant.empty() || term.error == 0.0) continue;
      const double off = std::max(std::abs(bar.value - reference->value) - reference->error, 0.0);
      Asked& asked = all[std::string(term.constant)];
      asked.in_use = term.in_use;
      asked.values.push_back(term.in_use * off / term.error);
    }
  }
}

Calibration calibrated(const std::vector<Point>& points) {
  constexpr int threads = 2;
  constexpr double tolerance = 1e-3;
  const Contacts contacts = make_contacts(points);
  Calibration all;
  stoss::run_in_order<Restitution>(
      points.size(), threads,
      [&](std::size_t i, const stoss::Poll&) {
        return best(contacts[i], points[i].speed, {.tolerance = tolerance, .absolute = least_error(points[i])});
      },
      [&](std::size_t i, Restitution&& result) { take(points[i], contacts[i].at(0), std::move(result), all); }, {});
  return all;
}

}  // namespace

bool write_calibration(std::ostream& out) {
  constexpr double quantile = 0.95, enough = 0.5;
  constexpr std::size_t fewest = 20;  // of which a quantile says something
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(), "%-14s %-26s %10s %6s %12s\n", "set", "constant", "in use", "runs",
                "asked, 95 %");
  out << line.data();
  bool all_enough = true;
  for (const Set& set : sets()) {
    if (!set.calibrates) continue;
    std::cerr << set.name << '\n';
    for (auto& [constant, asked] : calibrated(set.read())) {
      std::sort(asked.values.begin(), asked.values.end());
      const double wanted =
          asked.values[static_cast<std::size_t>(quantile * static_cast<double>(asked.values.size() - 1))];
      const bool tells = asked.values.size() >= fewest, met = !tells || asked.in_use >= enough * wanted;
      std::snprintf(line.data(), line.size(), "%-14s %-26s %10.3g %6zu %12.3g%s\n", set.name, constant.c_str(),
                    asked.in_use, asked.values.size(), wanted, met ? "" : "  too small");
      out << line.data() << std::flush;
      all_enough = all_enough && met;
    }
  }
  return all_enough;
}

}  // namespace validate
