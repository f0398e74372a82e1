#include "element_collision.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace bench {
namespace {

/// Nodes of a surface that may touch, from the axis outwards.
template <typename Is>
std::vector<std::size_t> sorted_nodes(const FiniteElements& body, const Is& is_of_surface) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < body.nodes().size(); ++i) {
    if (body.mass(i) > 0.0 && is_of_surface(body.nodes()[i])) result.push_back(i);
  }
  std::sort(result.begin(), result.end(),
            [&body](std::size_t i, std::size_t j) { return body.nodes()[i].across < body.nodes()[j].across; });
  return result;
}

std::vector<std::size_t> round_surface(const FiniteElements& body) {
  return sorted_nodes(body, [](const Point& point) {
    return point.towards > 0.0 && std::hypot(point.across, point.towards) > 1.0 - same_place;
  });
}

/// @param contact ends the overlaps of a step, and returns the impulse; at most 0, of the body that comes
template <typename Advance, typename Contact>
ElementCollision follow(double mass, double speed, double step, const Advance& advance, const Contact& contact) {
  constexpr double longest = 50.0;  // R/c
  constexpr double quiet = 0.3;     // without contact; shorter breaks were at most 0.05
  ElementCollision result;
  double impulse = 0.0;
  for (double time = 0.0; time < std::min(longest, result.contact_time + quiet); ++result.steps) {
    advance();
    time += step;
    const double received = contact();
    impulse += received;
    if (received != 0.0) result.contact_time = time;
  }
  const double after = 1.0 + impulse / (mass * speed);  // velocity over v
  result.lost_fraction = 1.0 - after * after;
  return result;
}

}  // namespace

ElementCollision collide(FiniteElements& body, double speed) {
  const double step = body.step();
  const std::vector<std::size_t> surface = round_surface(body);
  body.start(speed);
  return follow(
      body.mass(), speed, step, [&] { body.advance(step); },
      [&] {
        double impulse = 0.0;
        for (const std::size_t node : surface) {
          const double overlap = body.towards(node) - 1.0;
          if (overlap > 0.0) impulse += body.push(node, -overlap, step);
        }
        return impulse;
      });
}

ElementCollision collide(FiniteElements& ball, FiniteElements& block, double speed) {
  const double step = std::min(ball.step(), block.step());
  std::vector<std::size_t> above = round_surface(ball);
  std::vector<std::size_t> below = sorted_nodes(block, [](const Point& point) { return point.towards == 1.0; });
  std::size_t pairs = 0;
  for (; pairs < std::min(above.size(), below.size()); ++pairs) {
    const double apart = ball.nodes()[above[pairs]].across - block.nodes()[below[pairs]].across;
    if (std::abs(apart) > same_place) break;
  }
  ball.start(speed);
  block.start(0.0);
  return follow(
      ball.mass(), speed, step,
      [&] {
        ball.advance(step);
        block.advance(step);
      },
      [&] {
        double impulse = 0.0;
        for (std::size_t i = 0; i < pairs; ++i) {
          const double overlap = ball.towards(above[i]) - block.towards(below[i]);
          if (overlap <= 0.0) continue;
          const double share = block.mass(below[i]) / (ball.mass(above[i]) + block.mass(below[i]));
          impulse += ball.push(above[i], -share * overlap, step);
          block.push(below[i], (1.0 - share) * overlap, step);
        }
        return impulse;
      });
}

}  // namespace bench
