// A disk that bounces at a wall: without damping between its impacts until equipartition, and with damping.
#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "stoss/vibration/bounce.hpp"
#include "study.hpp"

namespace study {
namespace {

constexpr double speed = 0.1, flight_time = 30.0, partial = 30.0;
constexpr long few = 200, many = 6000, before_equilibrium = 2000;
constexpr int sequences = 8;  // without damping, of flight times 30, 31, …
constexpr int bins = 30;

/// What a sequence has been seen to do.
struct Sequence {
  std::vector<double> share;   ///< of translation in the energy before each impact
  std::vector<double> energy;  ///< mean share of each mode in equilibrium
  std::vector<stoss::ModeEnergy> modes;
};

Sequence sequence(long count, std::optional<double> decay_time, double flight) {
  Sequence result;
  stoss::BounceOptions options{.count = count, .flight_time = flight, .decay_time = decay_time};
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
  std::vector<Sequence> found(sequences);
  on_all_threads(found.size(),
                 [&](std::size_t k) { found[k] = sequence(many, std::nullopt, flight_time + static_cast<double>(k)); });
  const std::vector<double> part = sequence(few, partial, flight_time).share;
  const std::vector<double> complete = sequence(few, 0.0, flight_time).share;
  const std::vector<double>& none = found[0].share;

  auto out = fmt::output_file(name);
  out.print("# Share of translation in the first energy; disk, nu = 0.33, from {} c, flights of {} R/c.\n", speed,
            flight_time);
  out.print("number,no_damping,partial_damping,complete_damping\n");
  for (long n = 1; n <= many; ++n) {
    const auto i = static_cast<std::size_t>(n - 1);
    if (n <= few) out.print("{},{:.6f},{:.6f},{:.6f}\n", n, none[i], part[i], complete[i]);
    if (n > few && n % 20 == 0) out.print("{},{:.6f},,\n", n, none[i]);
  }

  auto shares = fmt::output_file(name_of_shares);
  shares.print(
      "# Without damping, impacts {} to {} of {} sequences: how many have a share of translation within each bin.\n",
      before_equilibrium + 1, many, sequences);
  shares.print("from,to,impacts\n");
  const double width = 0.3 / bins;
  for (int k = 0; k < bins; ++k) {
    const double from = width * k, to = k + 1 < bins ? from + width : 1.0;
    long within = 0;
    for (const Sequence& each : found) {
      within += std::count_if(each.share.begin() + before_equilibrium, each.share.end(),
                              [&](double share) { return share >= from && share < to; });
    }
    shares.print("{:.3f},{:.3f},{}\n", from, to, within);
  }

  auto modes = fmt::output_file(name_of_modes);
  modes.print("order,index,omega[c/R],mean_share,error\n");
  // The error is that of the mean of the sequences.
  const auto write = [&](const std::string& which, const auto& of) {
    double sum = 0.0, squares = 0.0;
    for (const Sequence& each : found) sum += of(each), squares += of(each) * of(each);
    const double mean = sum / sequences, variance = std::max(0.0, squares / sequences - mean * mean);
    modes.print("{},{:.6f},{:.6f}\n", which, mean, std::sqrt(variance / (sequences - 1)));
  };
  for (std::size_t k = 0; k < found[0].modes.size(); ++k) {
    const stoss::ModeEnergy& mode = found[0].modes[k];
    write(fmt::format("{},{},{:.6f}", mode.order, mode.index, mode.omega),
          [k](const Sequence& each) { return each.energy[k]; });
  }
  write("translation,,", [](const Sequence& each) {
    return std::accumulate(each.share.begin() + before_equilibrium, each.share.end(), 0.0) /
           (many - before_equilibrium);
  });
}

}  // namespace study
