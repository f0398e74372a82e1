#include "stoss/vibration/rod_chain_run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "numeric/random.hpp"
#include "stoss/errors.hpp"
#include "vibration/rod_vibrations.hpp"

namespace stoss {
namespace {

/// The next number of collisions after which the chain is looked at: the first fifty, then 2 % apart.
long sampled_after(long collisions) {
  constexpr double growth = 1.02;
  return std::max(collisions + 1, static_cast<long>(std::ceil(growth * static_cast<double>(collisions))));
}

}  // namespace

// Normal numbers √(−2 ln u₁) cos 2πu₂ (Box and Muller 1958).
std::vector<double> thermal_velocities(std::span<const Rod> rods, double temperature, std::uint64_t seed) {
  require("temperature", temperature, {0.0, 1e100, true, true, "0 to 1e100"}, "twice the mean kinetic energy of a rod");
  std::vector<double> velocities;
  double mass = 0.0, momentum = 0.0;
  for (const Rod& rod : rods) {
    static_cast<void>(scales(rod));  // refuses what is out of range
    const RodMeasures measures(rod);
    const auto [first, second] = numeric::uniform(seed, {static_cast<std::uint32_t>(velocities.size())});
    const double normal = std::sqrt(-2.0 * std::log(first)) * std::cos(2.0 * std::numbers::pi * second);
    velocities.push_back(std::sqrt(temperature / measures.mass) * normal);
    mass += measures.mass;
    momentum += measures.mass * velocities.back();
  }
  for (double& each : velocities) each -= momentum / mass;
  return velocities;
}

void run(RodChain& chain, RodChainRecord& record, long collisions, double time) {
  require("collisions", collisions, 0, 1'000'000'000, "of the chain");
  const RodChainSample start = chain.sample();
  if (!(time >= start.time)) {
    throw InvalidInput::out_of_range("time", shown(time), shown(start.time) + " or more", "until when the chain runs");
  }
  if (record.samples.empty()) record.samples.push_back(start);
  long next = sampled_after(start.collisions);
  for (long done = start.collisions;
       done < start.collisions + collisions && chain.next() <= time && std::isfinite(chain.next());) {
    record.collisions.push_back(chain.collide());
    if (++done == next) {
      record.samples.push_back(chain.sample());
      next = sampled_after(done);
    }
  }
  if (chain.next() > time && std::isfinite(time)) chain.fly(time);
  const RodChainSample end = chain.sample();
  if (end.time > record.samples.back().time || end.collisions > record.samples.back().collisions) {
    record.samples.push_back(end);
  }
}

}  // namespace stoss
