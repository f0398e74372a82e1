#pragma once

#include <string_view>

namespace stoss::table {

/// What c_rule_function is in C.
inline constexpr std::string_view js_rule_function = R"(
// Restitution, its error, sliding after, its error; what is not a number where the table says nothing.
function @name@_at(speed, sliding, friction, ratio, found) {
  const s = Math.abs(sliding), limit = friction * Math.abs(speed), scale = s + limit;
  let v = Math.abs(speed), p = @place@;
  for (let i = 0; i < 4; ++i) found[i] = NaN;
@unused@  if (!(v < Infinity && s < Infinity && @friction@@ratio@)) return;
  const inside = v >= @NAME@_SLOWEST && v <= @NAME@_FASTEST@inside@;
  if (!inside) {
    found[1] = found[3] = Infinity;
@outside@  }
  @name@_look_up(Math.log(v), scale > 0.0 ? (s - limit) / scale : -1.0, p, found);
  if (found[0] < 0.0) found[0] = 0.0;
  if (found[0] > 1.0) found[0] = 1.0;
  let after = found[2] * scale;
  if (after < -s) after = -s;
  if (after > s) after = s;
  found[2] = sliding < 0.0 ? -after : after;
  if (!inside) found[1] = found[3] = Infinity;
}
)";

/// What c_collide_functions are in C.
inline constexpr std::string_view js_collide_functions = R"(
// A round body is {inverse_mass, inverse_inertia, radius, velocity, spin}: inverse_mass 0 does not move, inverse_inertia
// 0 does not turn. In the plane velocity is [x, y], and spin, from x to y, a number; in space both are [x, y, z].

// The normal at length 1, from one of any length; undefined if it has no direction.
function @name@_direction(normal, count) {
  const n = [];
  let greatest = 0.0, square = 0.0;
  for (let i = 0; i < count; ++i) {
    if (!(Math.abs(normal[i]) < Infinity)) return undefined;
    if (Math.abs(normal[i]) > greatest) greatest = Math.abs(normal[i]);
  }
  if (!(greatest > 0.0)) return undefined;
  for (let i = 0; i < count; ++i) n[i] = normal[i] / greatest;
  for (let i = 0; i < count; ++i) square += n[i] * n[i];
  for (let i = 0; i < count; ++i) n[i] /= Math.sqrt(square);
  return n;
}

// Whether the numbers of a body are finite, and mass, moment of inertia and radius not negative.
function @name@_is_motion(body, velocity, spin) {
  let nothing = 0.0 * body.inverse_mass + 0.0 * body.inverse_inertia + 0.0 * body.radius;
  for (const each of velocity) nothing += 0.0 * each;
  for (const each of spin) nothing += 0.0 * each;
  return body.inverse_mass >= 0.0 && body.inverse_inertia >= 0.0 && body.radius >= 0.0 && nothing >= 0.0;
}

// The impulse along the normal, and that of friction against sliding s, over s; undefined if refused.
function @name@_impulse(speed, sliding, friction, ratio, mobility, turning) {
  const found = [];
  @name@_at(speed, sliding, friction, ratio, found);
  const slides = Math.abs(sliding) > 0.0;
  const along = slides ? (sliding - found[2]) / ((mobility + turning) * sliding) : 0.0 * found[2];
  return found[1] >= 0.0 ? [((1.0 + found[0]) * speed) / mobility, along] : undefined;
}

export function @name@_collide_2d(a, b, normal, friction) {
  const way = @name@_direction(normal, 2);
  if (!way || ![a, b].every((each) => @name@_is_motion(each, [each.velocity[0], each.velocity[1]], [each.spin]))) return -1;
  const [n, m] = way;
  const x = a.velocity[0] - b.velocity[0], y = a.velocity[1] - b.velocity[1];
  const mobility = a.inverse_mass + b.inverse_mass;
  const arm_a = a.radius * a.inverse_inertia, arm_b = b.radius * b.inverse_inertia;
  const speed = x * n + y * m, sliding = y * n - x * m + a.radius * a.spin + b.radius * b.spin;
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  const turning = a.radius * arm_a + b.radius * arm_b;
  const given = @name@_impulse(speed, sliding, friction, b.radius / a.radius, mobility, turning);
  if (!given) return -1;
  const push = given[0], drag = given[1] * sliding;
  const impulse = [push * n - drag * m, push * m + drag * n];
  for (let i = 0; i < 2; ++i) {
    a.velocity[i] -= a.inverse_mass * impulse[i];
    b.velocity[i] += b.inverse_mass * impulse[i];
  }
  a.spin -= arm_a * drag;
  b.spin -= arm_b * drag;
  return 1;
}

export function @name@_collide_3d(a, b, normal, friction) {
  const way = @name@_direction(normal, 3), three = (of) => [of[0], of[1], of[2]];
  if (!way || ![a, b].every((each) => @name@_is_motion(each, three(each.velocity), three(each.spin)))) return -1;
  const [n, m, l] = way;
  const [x, y, z] = [0, 1, 2].map((i) => a.velocity[i] - b.velocity[i]);
  const [p, q, r] = [0, 1, 2].map((i) => a.radius * a.spin[i] + b.radius * b.spin[i]);
  const mobility = a.inverse_mass + b.inverse_mass;
  const arm_a = a.radius * a.inverse_inertia, arm_b = b.radius * b.inverse_inertia;
  const speed = x * n + y * m + z * l;
  const u = x - speed * n + (q * l - r * m), v = y - speed * m + (r * n - p * l), w = z - speed * l + (p * m - q * n);
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  const sliding = Math.sqrt(u * u + v * v + w * w), turning = a.radius * arm_a + b.radius * arm_b;
  const given = @name@_impulse(speed, sliding, friction, b.radius / a.radius, mobility, turning);
  if (!given) return -1;
  const [push, drag] = given;
  const impulse = [push * n + drag * u, push * m + drag * v, push * l + drag * w];
  const moment = [drag * (m * w - l * v), drag * (l * u - n * w), drag * (n * v - m * u)];
  for (let i = 0; i < 3; ++i) {
    a.velocity[i] -= a.inverse_mass * impulse[i];
    b.velocity[i] += b.inverse_mass * impulse[i];
    a.spin[i] -= arm_a * moment[i];
    b.spin[i] -= arm_b * moment[i];
  }
  return 1;
}
)";

}  // namespace stoss::table
