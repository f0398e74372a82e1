#include "impact/oblique/rings/outward_impact.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "impact/oblique/coupled_collision.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/run.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {
namespace {

/// One run; empty if the contact outgrew the grid.
std::optional<OutwardImpact> run_once(const Contact& contact, const std::vector<Contact>& outward, double speed,
                                      double friction, const FixedResolution& resolution, const Poll& poll) {
  const ContactGrid grid = contact_grid(contact, resolution.half_width, resolution.nodes);
  const ObliqueFrame frame(contact, speed, {});
  CoupledCollision collision(contact, outward, resolution, grid, frame, {.friction = friction}, {}, poll);
  std::vector<OutwardStep> steps;
  std::size_t with_force = 0;
  const auto rest = run(contact, speed, resolution, poll, collision, [&](long /*step*/) {
    const bool pushes = collision.force().maxCoeff() > 0.0;
    if (!pushes && steps.empty()) return;
    steps.push_back({collision.force(), collision.friction(), collision.slip(), collision.give()});
    if (pushes) with_force = steps.size();
  });
  if (!rest) return std::nullopt;
  steps.resize(std::min(with_force + 1, steps.size()));  // with the rest of the last kick
  return OutwardImpact{collision.result(*rest), rest->stays() ? contact.mass * collision.velocity() : 0.0, resolution,
                       std::move(steps)};
}

}  // namespace

OutwardImpact outward_impact(const Contact& contact, const Contact& outward, double speed, double friction,
                             const Resolution& resolution, const Poll& poll) {
  FixedResolution fixed = fixed_resolution(contact, speed, resolution);
  OutwardImpact result = on_a_grid_that_suffices(contact, fixed, [&](const FixedResolution& each) {
    return run_once(contact, {outward}, speed, friction, each, poll);
  });
  const double lasted = result.momentum > 0.0 ? 0.0 : static_cast<double>(result.steps.size()) * fixed.step;
  require_known_for(contact, lasted);
  return result;
}

}  // namespace stoss
