// Time as an angle: √d = sin θ, θ from 0 to π, makes the normal motion analytic and even about its turning point,
//
//   ḋ = g cos θ,   dt = (2/g) sin θ dθ,   g² = (1 − σ⁵)/cos²θ = (1 + σ + σ² + σ³ + σ⁴)/(1 + σ),   σ = sin θ.
//
// U̇ = ψ₁ − 4χJ follows from the impulse J, of which a step adds the share T/N of −½Δḋ, half at its beginning and half
// at its end. U moves by the U̇ in between.
#include "quasistatic/oblique/tangential_contact.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <numbers>

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

namespace {

/// One instant of the normal motion.
struct Instant {
  double radius;    ///< √d
  double velocity;  ///< ḋ
  double rate;      ///< dt/dθ
};

double stretch(double sine) {  // g
  return std::sqrt((1.0 + sine * (1.0 + sine * (1.0 + sine * (1.0 + sine)))) / (1.0 + sine));
}

Instant instant(double angle) {
  const double sine = std::sin(angle), g = stretch(sine);
  return {sine, g * std::cos(angle), 2.0 * sine / g};
}

/// The member that has the time of what the contact does.
double& time_of(MawImpact& impact, const TangentialContact& contact) {
  if (contact.stick_radius() == contact.radius()) return impact.sticking;
  if (contact.stick_radius() > 0.0) return impact.slipping;
  return contact.force() > 0.0 ? impact.sliding : impact.reversed;
}

}  // namespace

MawImpact maw_path(double psi1, double chi, int steps) {
  MawImpact impact{.psi1 = psi1, .chi = chi};
  TangentialContact contact;
  double angle = 0.0, share = psi1;  // θ and T/N
  if (psi1 > 1.0) {
    const double begun = (psi1 - 1.0) / (2.0 * chi - 1.0), left = (sliding_limit(chi) - psi1) / (2.0 * chi - 1.0);
    const double sine = std::pow(begun * left, 0.2);  // where ḋ = U̇ = 1 − begun = left − 1
    angle = std::atan2(sine, (1.0 - begun) / stretch(sine));
    share = 1.0;
    impact.impulse = 0.5 * begun;
    contact = TangentialContact::sliding(std::pow(std::sin(angle), 2));
  }
  const double step = (std::numbers::pi - angle) / steps;
  const double contact_time = 0.8 * boost::math::beta(0.4, 0.5);
  double displacement = 0.0, time_left = contact_time;
  double* now = &impact.sticking;
  Instant last = instant(angle);
  for (int i = 1; i <= steps; ++i) {
    const bool apart = i == steps;
    const Instant middle = instant(angle + (i - 0.5) * step);
    const Instant next = apart ? Instant{0.0, -1.0, 0.0} : instant(angle + i * step);
    const double interval = step / 6.0 * (last.rate + 4.0 * middle.rate + next.rate);
    const double kick = 0.25 * (last.velocity - next.velocity);
    impact.impulse += kick * share;
    displacement += interval * (psi1 - 4.0 * chi * impact.impulse);
    double* const before = now;
    if (!apart) {
      contact.move(next.radius * next.radius, displacement);
      share = contact.force() / std::pow(next.radius, 3);
      now = &time_of(impact, contact);
    }
    impact.impulse += kick * share;
    *before += 0.5 * interval / contact_time;
    *now += 0.5 * interval / contact_time;
    time_left -= interval;
    last = next;
  }
  if (psi1 > 1.0) impact.sliding += time_left / contact_time;
  return impact;
}

}  // namespace stoss::quasistatic
