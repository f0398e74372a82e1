#include "contact/ellipse.hpp"

#include <cmath>
#include <utility>

#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// 1 − H/M.
double less_curved(double t) {
  const double square = t * t;
  return square * (0.66713 + square * (0.12242 + square * 0.08633));
}

}  // namespace

void require_round(const Body& body, double other) {
  constexpr double most = 4.0;
  const double mean = body.curvature + other, half = 0.5 * body.curvature_difference;
  if (mean > half && mean + half <= most * (mean - half)) return;
  throw InvalidInput::out_of_range(
      "curvature", "principal curvatures of '" + body.name + "' that make a long contact with what it meets",
      "relative ones up to 4 : 1");
}

std::shared_ptr<const Body> as_round(std::shared_ptr<const Body> body, double other) {
  if (body->curvature_difference == 0.0) return body;
  require_round(*body, other);
  const double mean = body->curvature + other;
  const double less = mean * less_curved(0.5 * body->curvature_difference / mean);
  Body round = *body;
  round.curvature -= less;
  round.curvature_difference = 0.0;
  round.surface = [own = body->surface, less](const ContactPoints& points) {
    Surface surface = own(points);
    for (std::size_t i = 0; i < points.count; ++i) {
      const double distance = points.radius * std::sin(points.angle(i));
      surface.recess[i] -= 0.5 * less * distance * distance;
    }
    return surface;
  };
  return std::make_shared<const Body>(std::move(round));
}

}  // namespace stoss
