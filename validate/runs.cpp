#include "runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "impact/refined_resolution.hpp"

namespace validate {
namespace {

stoss::Impact resolved(const stoss::Contact& contact, double speed, const Fineness& fineness, double half_width) {
  constexpr double fewest_nodes = 128.0;
  stoss::Resolution resolution = stoss::refined_resolution(contact, speed, half_width);
  resolution.nodes = static_cast<int>(std::max(fewest_nodes, std::ceil(fineness.nodes * resolution.nodes.value())));
  resolution.step = std::min(fineness.step / contact.cutoff, contact.stable_step);
  return stoss::impact(contact, speed, {.resolution = resolution});
}

void write_quantity(std::ostream& out, const Runs& runs, double stoss::Impact::*quantity, double least = 0.0) {
  double low = runs.back().*quantity, high = low;
  for (const stoss::Impact& run : runs) {
    low = std::min(low, run.*quantity);
    high = std::max(high, run.*quantity);
  }
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), ",%.8g,%.1e", runs.back().*quantity, std::max(high - low, least));
  out << text.data();
}

}  // namespace

Runs resolved_runs(const std::function<stoss::Contact(double cutoff)>& contact, double speed,
                   const Finenesses& finenesses) {
  const stoss::Impact coarse = stoss::impact(contact(25.0), speed);
  Runs runs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i] = resolved(contact(finenesses[i].cutoff), speed, finenesses[i], coarse.max_half_width);
  }
  return runs;
}

void write_quantities(std::ostream& out, const Runs& runs) {
  write_quantity(out, runs, &stoss::Impact::lost_fraction);
  write_quantity(out, runs, &stoss::Impact::contact_time, runs.back().step);  // noticed and lost within half a step
  write_quantity(out, runs, &stoss::Impact::impulse_time);
  write_quantity(out, runs, &stoss::Impact::max_force);
  write_quantity(out, runs, &stoss::Impact::max_compression);
  out << std::endl;  // one may look on
}

}  // namespace validate
