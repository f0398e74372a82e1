// Collision rule of two round elastic bodies with friction: speed v of approach along the normal, sliding s of the
// first body's point of contact over the second's, Coulomb's friction, ratio of the second radius to the first.
//
//   plain_rule_restitution(v, s, friction, ratio)  of the normal velocity, error at most 0.0011
//   plain_rule_sliding(v, s, friction, ratio)      s afterwards
//   plain_rule_collide_2d(&mut a, &mut b, normal, friction), _3d  changes velocities and spins, with the normal from a to b,
//                                              of any length but 0. 1: done. 0: they do not approach, and -1: the
//                                              normal has no direction, an argument is not finite, negative, or
//                                              none of the table (friction, ratio); then nothing changes
//
// Velocities are in c, spins times radii too. Errors, interpolation included, are those of
// plain_rule_restitution_error and plain_rule_sliding_error, the latter over |v_t| + |spin R| of both + friction v: at
// most 0.0014.
//
// The friction may be any.
// The ratio does not count.
// Speeds go from PLAIN_RULE_SLOWEST to PLAIN_RULE_FASTEST. Beyond, values are not numbers, errors f64::INFINITY.
//
// Where s = 0 there is no friction. |s afterwards| <= |s| and restitution <= 1: no collision gains energy.

#[allow(dead_code)]
pub const PLAIN_RULE_SLOWEST: f64 = 0.01;
#[allow(dead_code)]
pub const PLAIN_RULE_FASTEST: f64 = 0.2;

// ln(speed)
#[allow(non_upper_case_globals)]
static plain_rule_restitution_speeds: [f64; 4] = [
  -4.605170185988091, -3.912023005428146, -2.995732273553991, -1.6094379124341003
];
// interval in which each of equal parts of it begins
#[allow(non_upper_case_globals)]
static plain_rule_restitution_speeds_first: [usize; 5] = [
  0, 1, 2, 2, 2
];
// ln(speed)
#[allow(non_upper_case_globals)]
static plain_rule_sliding_speeds: [f64; 3] = [
  -4.605170185988091, -3.506557897319982, -1.6094379124341003
];
// interval in which each of equal parts of it begins
#[allow(non_upper_case_globals)]
static plain_rule_sliding_speeds_first: [usize; 4] = [
  0, 1, 1, 1
];
// z
#[allow(non_upper_case_globals)]
static plain_rule_sliding_slips: [f64; 8] = [
  -1.0, -0.5, 0.0, 0.5, 0.75, 0.8, 0.9, 1.0
];
// interval in which each of equal parts of it begins
#[allow(non_upper_case_globals)]
static plain_rule_sliding_slips_first: [usize; 9] = [
  0, 0, 1, 1, 2, 2, 3, 6, 6
];
// value at each crossing, and its derivatives along the axes
#[allow(non_upper_case_globals)]
static plain_rule_restitution_nodes: [f64; 8] = [
  0.945, -0.007213475204444827, 0.94, -0.009837716959933586, 0.9249999999999999,
  -0.02425164813614186, 0.85, -0.054101064033336095
];
// of each cell
#[allow(non_upper_case_globals)]
static plain_rule_restitution_errors: [f64; 3] = [
  0.0011, 0.0011, 0.0011
];
// value at each crossing, and its derivatives along the axes
#[allow(non_upper_case_globals)]
static plain_rule_sliding_nodes: [f64; 96] = [
  0.0, 0.0, -0.2286072469804248, 0.0043324505963729665, -0.0964493960849646, 0.0017628539790982012,
  -0.15719033735943358, 0.002718965320019838, -0.15719033735943358, 0.002718965320019838,
  0.006048313202832084, -0.0009690010259301514, -0.09040108288213253, 0.0007938529531680496,
  0.3822623906705541, -0.009468610963861718, 0.036250000000000004, -0.0022755980665671474,
  3.296934055254755, 0.005539026208732676, 0.2290000000000002, -0.0018204784532537784, 3.855,
  0.00910239226626771, 0.6145, -0.0009102392266269397, 3.8549999999999995, 0.009102392266268893,
  1.0, 0.0, 3.8550000000000013, 0.009102392266269906, 0.0, 0.0, -0.223847563515202,
  0.0068015706357273335, -0.09451270304039984, 0.0027675274287829923, -0.15420324864639737,
  0.004268539079404636, -0.15420324864639737, 0.004268539079404636, 0.0049837567680132006,
  -0.001521247335047225, -0.08952894627238664, 0.0012462800937357672, 0.371860058309038,
  -0.014864895712104184, 0.03374999999999995, -0.0035724910518860845, 3.3030192975149233,
  0.008695789409204378, 0.2270000000000001, -0.002857992841508947, 3.8649999999999993,
  0.01428996420754318, 0.6134999999999999, -0.0014289964207545413, 3.865, 0.014289964207544737, 1.0,
  0.0, 3.865000000000003, 0.014289964207546097, 0.0, 0.0, -0.18339025406080806,
  0.021325646125027554, -0.07805081216159936, 0.008677306132427214, -0.12881299458558937,
  0.0133835784046813, -0.12881299458558937, 0.0133835784046813, -0.004064972927946789,
  -0.004769719241824498, -0.08211578508954614, 0.003907586890602717, 0.28344023323615175,
  -0.04660739741150588, 0.012499999999999956, -0.01120118926019234, 3.3547438567263645,
  0.027264780100111838, 0.2100000000000002, -0.008960951408153825, 3.95, 0.04480475704076989, 0.605,
  -0.0044804757040769125, 3.95, 0.04480475704076913, 1.0, 0.0, 3.950000000000002,
  0.04480475704076913
];
// of each cell
#[allow(non_upper_case_globals)]
static plain_rule_sliding_errors: [f64; 14] = [
  0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135,
  0.00135, 0.00135, 0.00135
];

// The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
// of values a, b and slopes a', b' at its ends.
#[allow(non_snake_case)]
fn plain_rule_weigh(x: &[f64], first: &[usize], last: usize, bins: f64, at: f64, w: &mut [f64]) -> usize {
  let (h, t, u);
  let mut k;
  k = ((at - x[0]) * bins) as usize;
  if k > last { k = last; }
  k = first[k];
  while k + 1 < last && at >= x[k + 1] { k += 1; }
  h = x[k + 1] - x[k];
  t = (at - x[k]) / h;
  u = 1.0 - t;
  w[0] = t * t * (1.0 + 2.0 * u);
  w[1] = h * t * u * u;
  w[2] = h * t * u * t;
  return k;
}

#[allow(non_snake_case)]
fn plain_rule_sum_1(a: &[f64], next: usize, w: &[f64]) -> f64 {
  let b = &a[next..];
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}

#[allow(non_snake_case)]
fn plain_rule_sum_2(a: &[f64], next: usize, line: usize, w: &[f64], y: &[f64]) -> f64 {
  let b = &a[line..];
  let begin = plain_rule_sum_1(a, next, w);
  let end = plain_rule_sum_1(b, next, w);
  return begin + y[0] * (end - begin) + y[1] * plain_rule_sum_1(&a[2..], next, w) - y[2] * plain_rule_sum_1(&b[2..], next, w);
}

#[allow(non_snake_case, unused_mut)]
fn plain_rule_look_up(x: f64, z: f64, p: f64, found: &mut [f64]) {
  let mut w = [[0.0; 3]; 3];
  let mut k = [0; 3];
  k[0] = plain_rule_weigh(&plain_rule_restitution_speeds, &plain_rule_restitution_speeds_first, 3, 1.0014246020860023, x, &mut w[0]);
  k[1] = plain_rule_weigh(&plain_rule_sliding_speeds, &plain_rule_sliding_speeds_first, 2, 0.6676164013906682, x, &mut w[1]);
  k[2] = plain_rule_weigh(&plain_rule_sliding_slips, &plain_rule_sliding_slips_first, 7, 3.5, z, &mut w[2]);
  found[0] = plain_rule_sum_1(&plain_rule_restitution_nodes[(k[0] * 2)..], 2, &w[0]);
  found[1] = plain_rule_restitution_errors[k[0] * 1];
  found[2] = plain_rule_sum_2(&plain_rule_sliding_nodes[(k[1] * 32 + k[2] * 4)..], 32, 4, &w[1], &w[2]);
  found[3] = plain_rule_sliding_errors[k[1] * 7 + k[2] * 1];
  let _ = z;
  let _ = p;
}

// Restitution, its error, sliding after, its error; what is not a number where the table says nothing.
#[allow(non_snake_case, unused_mut)]
fn plain_rule_at(speed: f64, sliding: f64, friction: f64, ratio: f64, found: &mut [f64]) {
  let s = f64::abs(sliding);
  let limit = friction * f64::abs(speed);
  let scale = s + limit;
  let mut v = f64::abs(speed);
  let mut p = 0.0;
  for each in found.iter_mut() { *each = f64::NAN; }
  let _ = ratio;
  if !(v < f64::INFINITY && s < f64::INFINITY && friction >= 0.0 && friction < f64::INFINITY) { return; }
  let inside = v >= PLAIN_RULE_SLOWEST && v <= PLAIN_RULE_FASTEST;
  if !inside {
    found[1] = f64::INFINITY;
    found[3] = f64::INFINITY;
    return;
  }
  plain_rule_look_up(f64::ln(v), if scale > 0.0 { (s - limit) / scale } else { -1.0 }, p, found);
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

#[allow(dead_code, non_snake_case)]
pub fn plain_rule_restitution(speed: f64, sliding: f64, friction: f64, ratio: f64) -> f64 {
  let mut found = [0.0; 4];
  plain_rule_at(speed, sliding, friction, ratio, &mut found);
  return found[0];
}

#[allow(dead_code, non_snake_case)]
pub fn plain_rule_restitution_error(speed: f64, sliding: f64, friction: f64, ratio: f64) -> f64 {
  let mut found = [0.0; 4];
  plain_rule_at(speed, sliding, friction, ratio, &mut found);
  return found[1];
}

#[allow(dead_code, non_snake_case)]
pub fn plain_rule_sliding(speed: f64, sliding: f64, friction: f64, ratio: f64) -> f64 {
  let mut found = [0.0; 4];
  plain_rule_at(speed, sliding, friction, ratio, &mut found);
  return found[2];
}

#[allow(dead_code, non_snake_case)]
pub fn plain_rule_sliding_error(speed: f64, sliding: f64, friction: f64, ratio: f64) -> f64 {
  let mut found = [0.0; 4];
  plain_rule_at(speed, sliding, friction, ratio, &mut found);
  return found[3];
}

// A round body: inverse_mass 0 does not move, inverse_inertia 0 does not turn.
#[allow(dead_code, non_camel_case_types)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct plain_rule_body_2d {
  pub inverse_mass: f64,
  pub inverse_inertia: f64,
  pub radius: f64,
  pub velocity: [f64; 2],
  pub spin: f64, // from x to y
}

#[allow(dead_code, non_camel_case_types)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct plain_rule_body_3d {
  pub inverse_mass: f64,
  pub inverse_inertia: f64,
  pub radius: f64,
  pub velocity: [f64; 3],
  pub spin: [f64; 3],
}

// The normal at length 1, from one of any length; false if it has no direction.
#[allow(dead_code, non_snake_case)]
fn plain_rule_direction(normal: &[f64], n: &mut [f64]) -> bool {
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
fn plain_rule_is_motion(inverse_mass: f64, inverse_inertia: f64, radius: f64, velocity: &[f64], spin: &[f64]) -> bool {
  let mut nothing = 0.0 * inverse_mass + 0.0 * inverse_inertia + 0.0 * radius;
  for each in velocity { nothing += 0.0 * each; }
  for each in spin { nothing += 0.0 * each; }
  inverse_mass >= 0.0 && inverse_inertia >= 0.0 && radius >= 0.0 && nothing >= 0.0
}

// The impulse along the normal, and that of friction against sliding s, over s; None if refused.
#[allow(dead_code, non_snake_case)]
fn plain_rule_impulse(speed: f64, sliding: f64, friction: f64, ratio: f64, mobility: f64, turning: f64) -> Option<(f64, f64)> {
  let mut found = [0.0; 4];
  plain_rule_at(speed, sliding, friction, ratio, &mut found);
  let normal = (1.0 + found[0]) * speed / mobility;
  let slides = f64::abs(sliding) > 0.0;
  let along = if slides { (sliding - found[2]) / ((mobility + turning) * sliding) } else { 0.0 * found[2] };
  if found[1] >= 0.0 { Some((normal, along)) } else { None }
}

#[allow(dead_code, non_snake_case)]
pub fn plain_rule_collide_2d(a: &mut plain_rule_body_2d, b: &mut plain_rule_body_2d, normal: &[f64; 2], friction: f64) -> i32 {
  let (x, y) = (a.velocity[0] - b.velocity[0], a.velocity[1] - b.velocity[1]);
  let mobility = a.inverse_mass + b.inverse_mass;
  let (arm_a, arm_b) = (a.radius * a.inverse_inertia, b.radius * b.inverse_inertia);
  let mut way = [0.0; 2];
  if !plain_rule_direction(normal, &mut way)
    || !plain_rule_is_motion(a.inverse_mass, a.inverse_inertia, a.radius, &a.velocity, &[a.spin])
    || !plain_rule_is_motion(b.inverse_mass, b.inverse_inertia, b.radius, &b.velocity, &[b.spin]) { return -1; }
  let [n, m] = way;
  let speed = x * n + y * m;
  let sliding = y * n - x * m + a.radius * a.spin + b.radius * b.spin;
  if !(speed > 0.0) || !(mobility > 0.0) { return 0; }
  let turning = a.radius * arm_a + b.radius * arm_b;
  let (push, along) = match plain_rule_impulse(speed, sliding, friction, b.radius / a.radius, mobility, turning) {
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
pub fn plain_rule_collide_3d(a: &mut plain_rule_body_3d, b: &mut plain_rule_body_3d, normal: &[f64; 3], friction: f64) -> i32 {
  let mut relative = [0.0; 3];
  let mut turn = [0.0; 3];
  for i in 0..3 {
    relative[i] = a.velocity[i] - b.velocity[i];
    turn[i] = a.radius * a.spin[i] + b.radius * b.spin[i];
  }
  let mobility = a.inverse_mass + b.inverse_mass;
  let (arm_a, arm_b) = (a.radius * a.inverse_inertia, b.radius * b.inverse_inertia);
  let mut way = [0.0; 3];
  if !plain_rule_direction(normal, &mut way)
    || !plain_rule_is_motion(a.inverse_mass, a.inverse_inertia, a.radius, &a.velocity, &a.spin)
    || !plain_rule_is_motion(b.inverse_mass, b.inverse_inertia, b.radius, &b.velocity, &b.spin) { return -1; }
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
  let (push, drag) = match plain_rule_impulse(speed, sliding, friction, b.radius / a.radius, mobility, turning) {
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
