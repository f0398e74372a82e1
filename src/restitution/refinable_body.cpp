#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "check.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

struct RefinableBody::Levels {
  BodyMaker maker;
  std::mutex mutex;
  std::array<std::optional<Body>, highest_level + 1> bodies;
};

double RefinableBody::cutoff(int level) { return 8.0 * std::exp2(0.25 * level); }

RefinableBody::RefinableBody(BodyMaker maker) : levels_(std::make_shared<Levels>()) {
  if (!maker) throw InvalidInput("body: got no function that makes it, allowed one, such as disk(poisson)");
  levels_->maker = std::move(maker);
}

const Body& RefinableBody::at(int level, const Poll& poll) const {
  require("level", static_cast<long>(level), 0, highest_level, "of refinement");
  const std::lock_guard lock(levels_->mutex);
  std::optional<Body>& body = levels_->bodies[static_cast<std::size_t>(level)];
  if (!body) body = levels_->maker(cutoff(level), poll);
  return *body;
}

}  // namespace stoss
