#include "runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "impact/recommended.hpp"
#include "restitution/ordered_jobs.hpp"
#include "stoss/impact/impact.hpp"

namespace validate {
namespace {

constexpr int threads = 2;
constexpr double first_share = 0.3125;  // of the lowest cutoff: a run that says how wide the contact gets

stoss::Impact started(const stoss::Contact& contact, const ReferencePoint& point, stoss::ImpactOptions options) {
  if (!point.vibration.empty()) options.start = stoss::approach(contact, point.speed, point.vibration);
  return stoss::impact(contact, point.speed, options);
}

stoss::Impact resolved(const stoss::Contact& contact, const ReferencePoint& point, const Fineness& fineness,
                       double half_width) {
  return started(contact, point, {.resolution = finer(contact, point.speed, fineness, half_width)});
}

void write_quantity(std::ostream& out, const ImpactRuns& runs, double stoss::Impact::*quantity, double least = 0.0) {
  double low = runs.back().*quantity, high = low;
  for (const stoss::Impact& run : runs) {
    low = std::min(low, run.*quantity);
    high = std::max(high, run.*quantity);
    least = std::max(least, quantity == &stoss::Impact::lost_fraction ? run.remaining : 0.0);
  }
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), ",%.8g,%.1e", runs.back().*quantity, std::max(high - low, least));
  out << text.data();
}

void write_quantities(std::ostream& out, const ImpactRuns& runs) {
  write_quantity(out, runs, &stoss::Impact::lost_fraction);
  write_quantity(out, runs, &stoss::Impact::contact_time,
                 runs.back().resolution.step);  // noticed and lost within half a step
  write_quantity(out, runs, &stoss::Impact::impulse_time);
  write_quantity(out, runs, &stoss::Impact::max_force);
  write_quantity(out, runs, &stoss::Impact::max_compression);
  out << std::endl;  // one may look on
}

}  // namespace

stoss::Resolution finer(const stoss::Contact& contact, double speed, const Fineness& fineness, double half_width) {
  constexpr double fewest_nodes = 128.0;
  stoss::Resolution resolution = stoss::refined_resolution(contact, speed, half_width);
  resolution.nodes = static_cast<int>(std::max(fewest_nodes, std::ceil(fineness.nodes * resolution.nodes.value())));
  resolution.step = std::min(fineness.step / contact.cutoff, contact.stable_step);
  return resolution;
}

ImpactRuns resolved_runs(const ReferencePoint& point, const Finenesses& finenesses) {
  const double lowest = finenesses.front().cutoff;
  const double first = point.vibration.empty() ? std::min(25.0, first_share * lowest) : lowest;
  const stoss::Impact coarse = started(point.contact(first), point, {});
  ImpactRuns runs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const stoss::Contact contact = point.contact(finenesses[i].cutoff);
    const bool is_rough = contact.asperities > 0.0;  // they push beyond what counts as contact
    runs[i] = resolved(contact, point, finenesses[i], is_rough ? 0.0 : coarse.max_half_width);
  }
  return runs;
}

void write_reference(const std::string& path, const std::string& header, const std::vector<ReferencePoint>& points,
                     const Finenesses& finenesses) {
  std::vector<std::string> places;
  for (const ReferencePoint& point : points) places.push_back(point.place);
  write_reference(path, header, places, [&](std::size_t i) { return resolved_runs(points[i], finenesses); });
}

void write_reference(const std::string& path, const std::string& header, const std::vector<std::string>& places,
                     const std::function<ImpactRuns(std::size_t)>& compute) {
  std::ofstream file(path);
  file << header;
  stoss::run_in_order<std::optional<ImpactRuns>>(
      places.size(), threads,
      [&](std::size_t i, const stoss::Poll&) -> std::optional<ImpactRuns> {
        try {
          return compute(i);
        } catch (const std::exception& error) {
          std::cerr << '\n' << places[i] << ": " << error.what() << '\n';
          return std::nullopt;
        }
      },
      [&](std::size_t i, std::optional<ImpactRuns>&& runs) {
        if (runs) file << places[i];
        if (runs) write_quantities(file, *runs);
        std::cerr << "\rreference " << i + 1 << " of " << places.size() << std::flush;
      },
      {});
  std::cerr << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

double rounded(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return std::stod(text.data());
}

}  // namespace validate
