// A ring of rods that cool: kinetic energy against time with complete damping of their vibration between collisions,
// with partial and without damping, and how ε is distributed among the collisions.
#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stoss/vibration/ensemble.hpp"
#include "stoss/vibration/rod_chain_run.hpp"
#include "study.hpp"

namespace study {
namespace {

constexpr std::size_t rods = 40;
constexpr double other_length = 0.9, speed = 0.01, gap = 2.0;
constexpr long collisions = 4000, first = 501, last = 2500;  // of all, and in the distribution
constexpr double partial = 3e4;
constexpr int bins = 60;

stoss::RodChainRecord run(std::optional<double> decay_time) {
  std::vector<stoss::Rod> all(rods);
  std::vector<double> velocities(rods);
  double circumference = 0.0, momentum = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < rods; ++i) {
    if (i % 2 == 1) all[i].length = other_length;
    // A normal number: the coordinate of an oscillation of mean energy 1.
    const stoss::Oscillation drawn = stoss::draw({{0, 0, 0, 1.0}}, 16, i).front();
    velocities[i] = speed * std::sqrt(2.0 * drawn.energy) * std::cos(drawn.phase);
    circumference += all[i].length + gap;
    momentum += all[i].length * velocities[i];
    mass += all[i].length;
  }
  for (double& velocity : velocities) velocity -= momentum / mass;
  stoss::RodChain chain(all, circumference, velocities,
                        {.resolution = {.tail = stoss::Tail::quasistatic}, .decay_time = decay_time});
  stoss::RodChainRecord record;
  stoss::run(chain, record, collisions);
  return record;
}

}  // namespace

void write_chain(const std::string& name, const std::string& name_of_distribution) {
  const std::vector<std::pair<std::string, std::optional<double>>> kinds{
      {"none", std::nullopt}, {"partial", partial}, {"complete", 0.0}};
  std::vector<stoss::RodChainRecord> found(kinds.size());
  on_all_threads(kinds.size(), [&](std::size_t k) { found[k] = run(kinds[k].second); });

  auto out = fmt::output_file(name);
  out.print("# {} rods of lengths 1 and {}, gaps of {} at first, 50 modes; decay time of partial damping {}.\n", rods,
            other_length, gap, partial);
  out.print("damping,time[L/c],collisions,translation,vibration\n");
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const double whole = found[k].samples.front().translation;
    for (const stoss::RodChainSample& sample : found[k].samples) {
      out.print("{},{:.6g},{},{:.5e},{:.5e}\n", kinds[k].first, sample.time, sample.collisions,
                sample.translation / whole, sample.vibration / whole);
    }
  }

  auto shares = fmt::output_file(name_of_distribution);
  shares.print("# How many of the collisions {} to {} have a restitution within each bin.\n", first, last);
  shares.print("damping,from,to,collisions,mean,standard_deviation,greatest\n");
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const auto& all = found[k].collisions;
    const std::vector<stoss::RodCollision> seen(all.begin() + first - 1, all.begin() + last);
    double sum = 0.0, squares = 0.0, greatest = 0.0;
    for (const stoss::RodCollision& each : seen) {
      sum += each.restitution, squares += each.restitution * each.restitution;
      greatest = std::max(greatest, each.restitution);
    }
    const double count = static_cast<double>(seen.size()), mean = sum / count;
    for (int i = 0; i < bins; ++i) {
      const double from = 3.0 * i / bins, to = i + 1 < bins ? 3.0 * (i + 1) / bins : 1e9;
      const auto within = std::count_if(seen.begin(), seen.end(), [&](const stoss::RodCollision& each) {
        return each.restitution >= from && each.restitution < to;
      });
      shares.print("{},{:.3g},{:.3g},{},{:.5f},{:.5f},{:.4f}\n", kinds[k].first, from, to, within, mean,
                   std::sqrt(std::max(0.0, squares / count - mean * mean)), greatest);
    }
  }
}

}  // namespace study
