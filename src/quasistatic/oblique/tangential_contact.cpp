#include "quasistatic/oblique/tangential_contact.hpp"

#include <cmath>

namespace stoss::quasistatic {

TangentialContact TangentialContact::sliding(double approach) {
  TangentialContact contact;
  contact.knots_.front().rest = -approach;
  contact.append(approach, 0.0);
  return contact;
}

void TangentialContact::append(double square, double rest) {
  const Knot& last = knots_.back();
  Knot knot{.square = square, .rest = rest, .radius = std::sqrt(square), .integral = last.integral};
  if (square > last.square) {
    const double slope = (rest - last.rest) / (square - last.square);
    knot.integral += (last.rest - slope * last.square) * (knot.radius - last.radius) +
                     slope / 3.0 * (knot.radius * square - last.radius * last.square);
  }
  knots_.push_back(knot);
}

void TangentialContact::move(double approach, double displacement) {
  Knot outer = knots_.back();
  if (approach < outer.square) {  // springs leave
    while (knots_.back().square > approach) {
      outer = knots_.back();
      knots_.pop_back();
    }
    const Knot& inner = knots_.back();
    const double share = (approach - inner.square) / (outer.square - inner.square);
    append(approach, inner.rest + share * (outer.rest - inner.rest));
  }
  // Springs that would be beyond their limit slip, from the edge inwards.
  const double sign = displacement > knots_.back().rest ? 1.0 : -1.0;
  const auto slack = [&](const Knot& at) { return approach - at.square - sign * (displacement - at.rest); };
  stick_radius_ = std::sqrt(approach);
  if (slack(knots_.back()) < 0.0) {
    while (!knots_.empty() && slack(knots_.back()) < 0.0) {
      outer = knots_.back();
      knots_.pop_back();
    }
    if (knots_.empty()) {
      knots_.push_back({.rest = displacement - sign * approach});
    } else {
      const Knot& inner = knots_.back();
      const double share = slack(inner) / (slack(inner) - slack(outer));
      append(inner.square + share * (outer.square - inner.square), inner.rest + share * (outer.rest - inner.rest));
    }
    stick_radius_ = knots_.back().radius;
  }
  append(approach, displacement);
}

double TangentialContact::force() const {
  const Knot& edge = knots_.back();
  return 1.5 * (edge.rest * edge.radius - edge.integral);
}

}  // namespace stoss::quasistatic
