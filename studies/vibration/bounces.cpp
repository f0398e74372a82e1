// A disk that bounces at a wall: without damping between its impacts until equipartition, and with damping.
#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "stoss/vibration/bounce.hpp"
#include "study.hpp"

namespace study {
namespace {

constexpr double speed = 0.1, flight_time = 30.0, partial = 30.0;
constexpr long few = 200, many = 20000, before_equilibrium = 4000;
constexpr int bins = 30;

/// What a sequence has been seen to do.
struct Sequence {
  std::vector<double> share;   ///< of translation in the energy before each impact
  std::vector<double> energy;  ///< mean share of each mode in equilibrium
  std::vector<stoss::ModeEnergy> modes;
};

Sequence sequence(long count, std::optional<double> decay_time) {
  Sequence result;
  stoss::BounceOptions options{.count = count, .flight_time = flight_time, .decay_time = decay_time};
  options.resolution.tail = stoss::Tail::quasistatic;  // keeps all energy
  stoss::bounce(disk().contact.at(0), speed, options, [&](const stoss::Bounce& bounce, const stoss::Impact& hit) {
    result.share.push_back(bounce.before.translation);
    if (bounce.number <= before_equilibrium) return;
    result.modes = hit.energy.modes;
    result.energy.resize(result.modes.size());
    const double share = 1.0 / static_cast<double>(count - before_equilibrium);
    for (std::size_t k = 0; k < result.modes.size(); ++k) result.energy[k] += share * result.modes[k].before;
  });
  return result;
}

}  // namespace

void write_bounces(const std::string& name, const std::string& name_of_shares, const std::string& name_of_modes) {
  const std::vector<std::pair<long, std::optional<double>>> kinds{{many, std::nullopt}, {few, partial}, {few, 0.0}};
  std::vector<Sequence> found(kinds.size());
  on_all_threads(kinds.size(), [&](std::size_t k) { found[k] = sequence(kinds[k].first, kinds[k].second); });
  const std::vector<double>& none = found[0].share;

  auto out = fmt::output_file(name);
  out.print("# Share of translation in the first energy; disk, nu = 0.33, from {} c, flights of {} R/c.\n", speed,
            flight_time);
  out.print("number,no_damping,partial_damping,complete_damping,mean_in_equilibrium\n");
  double sum = 0.0;
  for (long n = 1; n <= many; ++n) {
    const auto i = static_cast<std::size_t>(n - 1);
    if (n > before_equilibrium) sum += none[i];
    if (n <= few) {
      out.print("{},{:.6f},{:.6f},{:.6f},\n", n, none[i], found[1].share[i], found[2].share[i]);
    } else if (n % 100 == 0) {
      out.print("{},{:.6f},,,", n, none[i]);
      if (n > before_equilibrium) out.print("{:.6f}", sum / static_cast<double>(n - before_equilibrium));
      out.print("\n");
    }
  }

  auto shares = fmt::output_file(name_of_shares);
  shares.print("# Without damping, impacts {} to {}: how many have a share of translation within each bin.\n",
               before_equilibrium + 1, many);
  shares.print("from,to,impacts\n");
  const double width = 0.3 / bins;
  for (int k = 0; k < bins; ++k) {
    const double from = width * k, to = k + 1 < bins ? from + width : 1.0;
    const auto within = std::count_if(none.begin() + before_equilibrium, none.end(),
                                      [&](double share) { return share >= from && share < to; });
    shares.print("{:.3f},{:.3f},{}\n", from, to, within);
  }

  auto modes = fmt::output_file(name_of_modes);
  modes.print("order,index,omega[c/R],mean_share\n");
  for (std::size_t k = 0; k < found[0].modes.size(); ++k) {
    const stoss::ModeEnergy& mode = found[0].modes[k];
    modes.print("{},{},{:.6f},{:.6f}\n", mode.order, mode.index, mode.omega, found[0].energy[k]);
  }
}

}  // namespace study
