// What the paper does before its production run: which modes, which step. (Its observation that 75 % of the modes have
// n = 0 does not come out: of the 940 most energetic of the 4510 modes with ω ≤ 100, 30 have.)
#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "paper_protocol.hpp"
#include "stoss/impact/impact.hpp"

namespace bench {

stoss::Body most_energetic(const stoss::Body& disk, std::size_t count, const PaperSettings& settings) {
  const stoss::ExponentialWall wall{settings.hardness, settings.strength};
  const std::vector<stoss::ModeEnergy> modes = stoss::impact(disk, wall, settings.speed).energy.modes;
  std::vector<double> energies;
  energies.reserve(modes.size());
  for (const stoss::ModeEnergy& mode : modes) energies.push_back(mode.average);
  const auto last = energies.begin() + static_cast<std::ptrdiff_t>(std::min(count, energies.size())) - 1;
  std::nth_element(energies.begin(), last, energies.end(), std::greater<>());
  const double least = *last;

  stoss::Body result = disk;
  result.groups.clear();
  std::size_t mode = 0;
  for (const stoss::ModeGroup& all : disk.groups) {
    stoss::ModeGroup kept{all.order, {}, {}, {}, all.upper_row, all.lower_row};
    for (std::size_t l = 0; l < all.omega.size(); ++l, ++mode) {
      if (modes[mode].average < least) continue;
      kept.omega.push_back(all.omega[l]);
      kept.upper.push_back(all.upper[l]);
      kept.lower.push_back(all.lower[l]);
    }
    result.groups.push_back(kept);  // also an empty one: the grid has a row for each group
  }
  return result;
}

std::vector<stoss::ModeGroup> mode_by_mode(const std::vector<stoss::ModeGroup>& modes) {
  std::vector<stoss::ModeGroup> result;
  for (const stoss::ModeGroup& group : modes) {
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      result.push_back({group.order, {group.omega[l]}, {group.upper[l]}, {group.lower[l]}});
    }
  }
  return result;
}

double largest_step(const std::vector<stoss::ModeGroup>& modes, PaperSettings settings, double tolerance) {
  const auto suffices = [&](double step) {
    settings.step = step;
    return paper_impact(modes, settings).energy_error < tolerance;
  };
  double good = 0.1;
  while (!suffices(good)) good *= 0.5;
  double bad = 2.0 * good;
  while (bad > 1.05 * good) {
    const double middle = 0.5 * (good + bad);
    (suffices(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace bench
