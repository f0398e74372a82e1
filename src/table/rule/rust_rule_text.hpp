#pragma once

#include <string_view>

namespace stoss::table {

/// What c_rule_function is in C.
inline constexpr std::string_view rust_rule_function = R"(
// Restitution, its error, sliding after, its error; what is not a number where the table says nothing.
#[allow(non_snake_case, unused_mut)]
fn @name@_at(speed: f64, sliding: f64, friction: f64, ratio: f64, found: &mut [f64]) {
  let s = f64::abs(sliding);
  let limit = friction * f64::abs(speed);
  let scale = s + limit;
  let mut v = f64::abs(speed);
  let mut p = @place@;
  for each in found.iter_mut() { *each = f64::NAN; }
@unused@  if !(v < f64::INFINITY && s < f64::INFINITY && @friction@@ratio@) { return; }
  let inside = v >= @NAME@_SLOWEST && v <= @NAME@_FASTEST@inside@;
  if !inside {
    found[1] = f64::INFINITY;
    found[3] = f64::INFINITY;
@outside@  }
  @name@_look_up(f64::ln(v), if scale > 0.0 { (s - limit) / scale } else { -1.0 }, p, found);
  if found[0] < 0.0 { found[0] = 0.0; }
  if found[0] > 1.0 { found[0] = 1.0; }
  let mut after = found[2] * scale;
  if after < -s { after = -s; }
  if after > s { after = s; }
  found[2] = if sliding < 0.0 { -after } else { after };
  if !inside {
    found[1] = f64::INFINITY;
    found[3] = f64::INFINITY;
  }
}
)";

/// What c_collide_functions are in C.
inline constexpr std::string_view rust_collide_functions = R"(
// A round body: inverse_mass 0 does not move, inverse_inertia 0 does not turn.
#[allow(dead_code, non_camel_case_types)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct @name@_body_2d {
  pub inverse_mass: f64,
  pub inverse_inertia: f64,
  pub radius: f64,
  pub velocity: [f64; 2],
  pub spin: f64, // from x to y
}

#[allow(dead_code, non_camel_case_types)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct @name@_body_3d {
  pub inverse_mass: f64,
  pub inverse_inertia: f64,
  pub radius: f64,
  pub velocity: [f64; 3],
  pub spin: [f64; 3],
}

// The normal at length 1, from one of any length; false if it has no direction.
#[allow(dead_code, non_snake_case)]
fn @name@_direction(normal: &[f64], n: &mut [f64]) -> bool {
  let mut greatest = 0.0;
  let mut square = 0.0;
  for each in normal {
    if !(f64::abs(*each) < f64::INFINITY) { return false; }
    if f64::abs(*each) > greatest { greatest = f64::abs(*each); }
  }
  if !(greatest > 0.0) { return false; }
  for i in 0..n.len() { n[i] = normal[i] / greatest; }
  for each in n.iter() { square += each * each; }
  for each in n.iter_mut() { *each /= f64::sqrt(square); }
  true
}

// Whether the numbers of a body are finite, and mass, moment of inertia and radius not negative.
#[allow(dead_code, non_snake_case)]
fn @name@_is_motion(inverse_mass: f64, inverse_inertia: f64, radius: f64, velocity: &[f64], spin: &[f64]) -> bool {
  let mut nothing = 0.0 * inverse_mass + 0.0 * inverse_inertia + 0.0 * radius;
  for each in velocity { nothing += 0.0 * each; }
  for each in spin { nothing += 0.0 * each; }
  inverse_mass >= 0.0 && inverse_inertia >= 0.0 && radius >= 0.0 && nothing >= 0.0
}

// The impulse along the normal, and that of friction against sliding s, over s; None if refused.
#[allow(dead_code, non_snake_case)]
fn @name@_impulse(speed: f64, sliding: f64, friction: f64, ratio: f64, mobility: f64, turning: f64) -> Option<(f64, f64)> {
  let mut found = [0.0; 4];
  @name@_at(speed, sliding, friction, ratio, &mut found);
  let normal = (1.0 + found[0]) * speed / mobility;
  let slides = f64::abs(sliding) > 0.0;
  let along = if slides { (sliding - found[2]) / ((mobility + turning) * sliding) } else { 0.0 * found[2] };
  if found[1] >= 0.0 { Some((normal, along)) } else { None }
}

#[allow(dead_code, non_snake_case)]
pub fn @name@_collide_2d(a: &mut @name@_body_2d, b: &mut @name@_body_2d, normal: &[f64; 2], friction: f64) -> i32 {
  let (x, y) = (a.velocity[0] - b.velocity[0], a.velocity[1] - b.velocity[1]);
  let mobility = a.inverse_mass + b.inverse_mass;
  let (arm_a, arm_b) = (a.radius * a.inverse_inertia, b.radius * b.inverse_inertia);
  let mut way = [0.0; 2];
  if !@name@_direction(normal, &mut way)
    || !@name@_is_motion(a.inverse_mass, a.inverse_inertia, a.radius, &a.velocity, &[a.spin])
    || !@name@_is_motion(b.inverse_mass, b.inverse_inertia, b.radius, &b.velocity, &[b.spin]) { return -1; }
  let [n, m] = way;
  let speed = x * n + y * m;
  let sliding = y * n - x * m + a.radius * a.spin + b.radius * b.spin;
  if !(speed > 0.0) || !(mobility > 0.0) { return 0; }
  let turning = a.radius * arm_a + b.radius * arm_b;
  let (push, along) = match @name@_impulse(speed, sliding, friction, b.radius / a.radius, mobility, turning) {
    Some(impulse) => impulse,
    None => return -1,
  };
  let drag = along * sliding;
  let impulse = [push * n - drag * m, push * m + drag * n];
  for i in 0..2 {
    a.velocity[i] -= a.inverse_mass * impulse[i];
    b.velocity[i] += b.inverse_mass * impulse[i];
  }
  a.spin -= arm_a * drag;
  b.spin -= arm_b * drag;
  1
}

#[allow(dead_code, non_snake_case)]
pub fn @name@_collide_3d(a: &mut @name@_body_3d, b: &mut @name@_body_3d, normal: &[f64; 3], friction: f64) -> i32 {
  let mut relative = [0.0; 3];
  let mut turn = [0.0; 3];
  for i in 0..3 {
    relative[i] = a.velocity[i] - b.velocity[i];
    turn[i] = a.radius * a.spin[i] + b.radius * b.spin[i];
  }
  let mobility = a.inverse_mass + b.inverse_mass;
  let (arm_a, arm_b) = (a.radius * a.inverse_inertia, b.radius * b.inverse_inertia);
  let mut way = [0.0; 3];
  if !@name@_direction(normal, &mut way)
    || !@name@_is_motion(a.inverse_mass, a.inverse_inertia, a.radius, &a.velocity, &a.spin)
    || !@name@_is_motion(b.inverse_mass, b.inverse_inertia, b.radius, &b.velocity, &b.spin) { return -1; }
  let [n, m, l] = way;
  let [x, y, z] = relative;
  let [p, q, r] = turn;
  let speed = x * n + y * m + z * l;
  let u = x - speed * n + (q * l - r * m);
  let v = y - speed * m + (r * n - p * l);
  let w = z - speed * l + (p * m - q * n);
  if !(speed > 0.0) || !(mobility > 0.0) { return 0; }
  let sliding = f64::sqrt(u * u + v * v + w * w);
  let turning = a.radius * arm_a + b.radius * arm_b;
  let (push, drag) = match @name@_impulse(speed, sliding, friction, b.radius / a.radius, mobility, turning) {
    Some(impulse) => impulse,
    None => return -1,
  };
  let impulse = [push * n + drag * u, push * m + drag * v, push * l + drag * w];
  let moment = [drag * (m * w - l * v), drag * (l * u - n * w), drag * (n * v - m * u)];
  for i in 0..3 {
    a.velocity[i] -= a.inverse_mass * impulse[i];
    b.velocity[i] += b.inverse_mass * impulse[i];
    a.spin[i] -= arm_a * moment[i];
    b.spin[i] -= arm_b * moment[i];
  }
  1
}
)";

}  // namespace stoss::table
