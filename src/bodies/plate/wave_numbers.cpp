// Quadratures over the wave number, of as many nodes as waves turn in phase within the contact.
#include "bodies/plate/plate_waves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bodies/plate/branches.hpp"
#include "check.hpp"
#include "numeric/quadrature.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::plate {
namespace {

bool has_modes(const Lamina& plate, double k, double cutoff) {
  const std::vector<Sheets>& parts = plate.parts(k);
  return std::any_of(parts.begin(), parts.end(), [&](const Sheets& part) {
    const Sheets its = reached(part, k, cutoff);
    return count_below<2>(its, k, cutoff) > 0 || count_below<1>(its, k, cutoff) > 0;
  });
}

/// A range of wave numbers, and what bounds the speed of energy in it.
struct Panel {
  double begin, end, speed;
};

/// With ω ≤ cutoff. In sheets, and in layers in which no waves run, energy is no faster than 2ω/k. The speed stands for
/// the distance, too, over which the shapes of waves turn: that of the contact's points, which shear waves cross in a
/// fifth of the time (an estimate: with a tenth or two fifths, loss, force, time and compression on five plates of
/// unlike layers and on sheets change by less than 4·10⁻⁷).
std::vector<Panel> panels(const Lamina& plate, double cutoff, const Poll& poll) {
  const double pressure = cutoff / plate.pressure_speed, shear = cutoff / plate.shear_speed;
  const double last = highest_kept(plate, cutoff, poll);
  std::vector<Panel> all{{0.0, pressure, plate.pressure_speed}, {pressure, shear, plate.shear_speed}};
  constexpr double unlike = 16.0, across = 0.2;
  if (last < unlike * shear) {
    // Where modes slower than the shear waves are all that is kept, they carry energy no faster than these.
    all.push_back({shear, last, plate.shear_speed});
    return all;
  }
  for (double begin = shear; begin < last;) {
    const double end = last < 3.0 * begin ? last : 2.0 * begin;
    all.push_back({begin, end, std::clamp(2.0 * cutoff / begin, across * plate.shear_speed, plate.shear_speed)});
    begin = end;
  }
  return all;
}

}  // namespace

Sheets reached(const Sheets& part, double k, double cutoff) {
  constexpr double negligible = 20.0;  // e^−20 there, e^−40 in what a load on the face sees
  double decay = 0.0;
  for (std::size_t i = 0; i + 1 < part.all.size(); ++i) {
    const Sheet& sheet = part.all[i];
    const double along = k * k - cutoff * cutoff * sheet.density / sheet.shear_modulus;
    decay += sheet.thickness * std::sqrt(std::max(along, 0.0));
    if (decay < negligible) continue;
    return {{part.all.begin(), part.all.begin() + static_cast<std::ptrdiff_t>(i + 1)}, Floor::free, part.share};
  }
  return part;
}

double highest_kept(const Lamina& plate, double cutoff, const Poll& poll) {
  double high = cutoff / plate.shear_speed;
  for (; has_modes(plate, high, cutoff); high *= 2.0) {
    if (poll) poll();
  }
  double low = 0.5 * high;
  constexpr double close = 1e-9;
  while (high - low > close * high) {
    if (poll) poll();
    const double middle = 0.5 * (low + high);
    (has_modes(plate, middle, cutoff) ? low : high) = middle;
  }
  return high;
}

std::vector<WaveNumber> wave_numbers(const Lamina& plate, double cutoff, double duration, const Poll& poll) {
  constexpr double surplus = 1.1, more = 8.0, most = 1e5;
  constexpr double most_of_rule = 2000.0;  // which takes as their square to make
  const auto nodes_of = [time = share_of_duration * duration](const Panel& panel) {
    return 0.25 * surplus * (panel.end - panel.begin) * panel.speed * time;
  };
  const std::vector<Panel> ranges = panels(plate, cutoff, poll);
  double count = 0.0;
  for (const Panel& panel : ranges) count += nodes_of(panel);
  if (!(count < most)) {
    throw InvalidInput::out_of_range(
        "cutoff", shown(cutoff) + " of a plate for contacts of " + shown(duration) + " in its own time",
        "a lower one, or layers that are less unlike", "more waves than are computed");
  }
  std::vector<WaveNumber> all;
  for (const Panel& panel : ranges) {
    const double nodes = nodes_of(panel), parts = std::max(1.0, std::ceil(nodes / most_of_rule));
    const double half = 0.5 * (panel.end - panel.begin) / parts;
    const auto& rule = numeric::gauss_legendre(static_cast<int>(std::ceil(nodes / parts + more)), poll);
    for (double part = 0.0; part < parts; ++part) {
      const double middle = panel.begin + (2.0 * part + 1.0) * half;
      for (std::size_t i = 0; i < rule.node.size(); ++i) {
        all.push_back({middle + half * rule.node[i], half * rule.weight[i]});
      }
    }
  }
  return all;
}

}  // namespace stoss::bodies::plate
