#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "digits.hpp"
#include "stoss/errors.hpp"
#include "stoss/vibration/rod_chain.hpp"

namespace stoss {
namespace {

/// The next number of collisions after which the chain is looked at: the first fifty, then 2 % apart.
long sampled_after(long collisions) {
  constexpr double growth = 1.02;
  return std::max(collisions + 1, static_cast<long>(std::ceil(growth * static_cast<double>(collisions))));
}

}  // namespace

void run(RodChain& chain, RodChainRecord& record, long collisions, double time) {
  require("collisions", collisions, 0, 1'000'000'000, "of the chain");
  const RodChainSample start = chain.sample();
  if (!(time >= start.time)) {
    throw InvalidInput("time: got " + shown(time) + ", allowed " + shown(start.time) +
                       " or more (until when the chain runs)");
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
