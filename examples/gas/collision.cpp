// With the relative velocity g of the first particle, v = g·n of approach and s = g − v n + (Ω₁R₁ + Ω₂R₂) × n of the
// surfaces, the impulses on the first are −J n and −T s/|s|:
//
//     J = μ(1 + ε) v,   T = (|s| − s′) μ/(1 + mR²/I),   μ = m₁m₂/(m₁ + m₂),
//
// as mR²/I is the same of both.
#include "collision.hpp"

#include <utility>

namespace gas {

Rule smooth(Law law) {
  return [law = std::move(law)](double speed, double sliding, double ratio) {
    return Outcome{law(speed, ratio), sliding};
  };
}

template <std::size_t D>
double collide(Particle<D>& first, Particle<D>& second, const Vector<D>& normal, const Rule& rule) {
  Vector<D> relative = first.velocity;
  add(relative, -1.0, second.velocity);
  const double speed = dot(relative, normal);
  if (!(speed > 0.0)) return 0.0;
  Spin<D> turning{};
  add(turning, first.radius, first.spin);
  add(turning, second.radius, second.spin);
  Vector<D> slide = relative;
  add(slide, -speed, normal);
  add(slide, 1.0, turned(turning, normal));
  const double sliding = length(slide);
  const Outcome outcome = rule(speed, sliding, second.radius / first.radius);

  const double reduced = first.mass * second.mass / (first.mass + second.mass);
  const double impulse = reduced * (1.0 + outcome.restitution) * speed;
  add(first.velocity, -impulse / first.mass, normal);
  add(second.velocity, impulse / second.mass, normal);
  if (outcome.sliding_after == sliding) return impulse;
  const double arm = 1.0 + first.mass * first.radius * first.radius / first.inertia;
  const double friction = (sliding - outcome.sliding_after) * reduced / (arm * sliding);
  add(first.velocity, -friction / first.mass, slide);
  add(second.velocity, friction / second.mass, slide);
  const Spin<D> turn = moment(normal, slide);
  add(first.spin, -friction * first.radius / first.inertia, turn);
  add(second.spin, -friction * second.radius / second.inertia, turn);
  return impulse;
}

template double collide(Particle<2>&, Particle<2>&, const Vector<2>&, const Rule&);
template double collide(Particle<3>&, Particle<3>&, const Vector<3>&, const Rule&);

}  // namespace gas
