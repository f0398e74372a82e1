// Collision rule of two round elastic bodies with friction: speed v of approach along the normal, sliding s of the
// first body's point of contact over the second's, Coulomb's friction, ratio of the second radius to the first.
//
//   plain_rule_restitution(v, s, friction, ratio)  of the normal velocity, error at most 0.0011
//   plain_rule_sliding(v, s, friction, ratio)      s afterwards
//   plain_rule_collide_2d(a, b, normal, friction), _3d  changes velocities and spins, with the normal from a to b,
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
// Speeds go from PLAIN_RULE_SLOWEST to PLAIN_RULE_FASTEST. Beyond, values are not numbers, errors Infinity.
//
// Where s = 0 there is no friction. |s afterwards| <= |s| and restitution <= 1: no collision gains energy.

export const PLAIN_RULE_SLOWEST = 0.01;
export const PLAIN_RULE_FASTEST = 0.2;

// ln(speed)
const plain_rule_restitution_speeds = new Float64Array([
  -4.605170185988091, -3.912023005428146, -2.995732273553991, -1.6094379124341003
]);
// interval in which each of equal parts of it begins
const plain_rule_restitution_speeds_first = new Int32Array([
  0, 1, 2, 2, 2
]);
// ln(speed)
const plain_rule_sliding_speeds = new Float64Array([
  -4.605170185988091, -3.506557897319982, -1.6094379124341003
]);
// interval in which each of equal parts of it begins
const plain_rule_sliding_speeds_first = new Int32Array([
  0, 1, 1, 1
]);
// z
const plain_rule_sliding_slips = new Float64Array([
  -1.0, -0.5, 0.0, 0.5, 0.75, 0.8, 0.9, 1.0
]);
// interval in which each of equal parts of it begins
const plain_rule_sliding_slips_first = new Int32Array([
  0, 0, 1, 1, 2, 2, 3, 6, 6
]);
// value at each crossing, and its derivatives along the axes
const plain_rule_restitution_nodes = new Float64Array([
  0.945, -0.007213475204444827, 0.94, -0.009837716959933586, 0.9249999999999999,
  -0.02425164813614186, 0.85, -0.054101064033336095
]);
// of each cell
const plain_rule_restitution_errors = new Float64Array([
  0.0011, 0.0011, 0.0011
]);
// value at each crossing, and its derivatives along the axes
const plain_rule_sliding_nodes = new Float64Array([
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
]);
// of each cell
const plain_rule_sliding_errors = new Float64Array([
  0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135,
  0.00135, 0.00135, 0.00135
]);

// The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
// of values a, b and slopes a', b' at its ends.
function plain_rule_weigh(x, first, last, bins, at, w) {
  let h, t, u;
  let k;
  k = Math.trunc((at - x[0]) * bins);
  if (k < 0) k = 0;
  if (k > last) k = last;
  k = first[k];
  while (k + 1 < last && at >= x[k + 1]) ++k;
  h = x[k + 1] - x[k];
  t = (at - x[k]) / h;
  u = 1.0 - t;
  w[0] = t * t * (1.0 + 2.0 * u);
  w[1] = h * t * u * u;
  w[2] = h * t * u * t;
  return k;
}

function plain_rule_sum_1(a, next, w) {
  const b = a.subarray(next);
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}

function plain_rule_sum_2(a, next, line, w, y) {
  const b = a.subarray(line);
  const begin = plain_rule_sum_1(a, next, w), end = plain_rule_sum_1(b, next, w);
  return begin + y[0] * (end - begin) + y[1] * plain_rule_sum_1(a.subarray(2), next, w) - y[2] * plain_rule_sum_1(b.subarray(2), next, w);
}

function plain_rule_look_up(x, z, p, found) {
  const w = [], k = [];
  for (let i = 0; i < 3; ++i) w[i] = [0.0, 0.0, 0.0];
  k[0] = plain_rule_weigh(plain_rule_restitution_speeds, plain_rule_restitution_speeds_first, 3, 1.0014246020860023, x, w[0]);
  k[1] = plain_rule_weigh(plain_rule_sliding_speeds, plain_rule_sliding_speeds_first, 2, 0.6676164013906682, x, w[1]);
  k[2] = plain_rule_weigh(plain_rule_sliding_slips, plain_rule_sliding_slips_first, 7, 3.5, z, w[2]);
  found[0] = plain_rule_sum_1(plain_rule_restitution_nodes.subarray((k[0] * 2)), 2, w[0]);
  found[1] = plain_rule_restitution_errors[k[0] * 1];
  found[2] = plain_rule_sum_2(plain_rule_sliding_nodes.subarray((k[1] * 32 + k[2] * 4)), 32, 4, w[1], w[2]);
  found[3] = plain_rule_sliding_errors[k[1] * 7 + k[2] * 1];
  void z;
  void p;
}

// Restitution, its error, sliding after, its error; what is not a number where the table says nothing.
function plain_rule_at(speed, sliding, friction, ratio, found) {
  const s = Math.abs(sliding), limit = friction * Math.abs(speed), scale = s + limit;
  let v = Math.abs(speed), p = 0.0;
  for (let i = 0; i < 4; ++i) found[i] = NaN;
  void ratio;
  if (!(v < Infinity && s < Infinity && friction >= 0.0 && friction < Infinity)) return;
  const inside = v >= PLAIN_RULE_SLOWEST && v <= PLAIN_RULE_FASTEST;
  if (!inside) {
    found[1] = found[3] = Infinity;
    return;
  }
  plain_rule_look_up(Math.log(v), scale > 0.0 ? (s - limit) / scale : -1.0, p, found);
  if (found[0] < 0.0) found[0] = 0.0;
  if (found[0] > 1.0) found[0] = 1.0;
  let after = found[2] * scale;
  if (after < -s) after = -s;
  if (after > s) after = s;
  found[2] = sliding < 0.0 ? -after : after;
  if (!inside) found[1] = found[3] = Infinity;
}

export function plain_rule_restitution(speed, sliding, friction, ratio) {
  const found = [];
  plain_rule_at(speed, sliding, friction, ratio, found);
  return found[0];
}

export function plain_rule_restitution_error(speed, sliding, friction, ratio) {
  const found = [];
  plain_rule_at(speed, sliding, friction, ratio, found);
  return found[1];
}

export function plain_rule_sliding(speed, sliding, friction, ratio) {
  const found = [];
  plain_rule_at(speed, sliding, friction, ratio, found);
  return found[2];
}

export function plain_rule_sliding_error(speed, sliding, friction, ratio) {
  const found = [];
  plain_rule_at(speed, sliding, friction, ratio, found);
  return found[3];
}

// A round body is {inverse_mass, inverse_inertia, radius, velocity, spin}: inverse_mass 0 does not move, inverse_inertia
// 0 does not turn. In the plane velocity is [x, y], and spin, from x to y, a number; in space both are [x, y, z].

// The normal at length 1, from one of any length; undefined if it has no direction.
function plain_rule_direction(normal, count) {
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
function plain_rule_is_motion(body, velocity, spin) {
  let nothing = 0.0 * body.inverse_mass + 0.0 * body.inverse_inertia + 0.0 * body.radius;
  for (const each of velocity) nothing += 0.0 * each;
  for (const each of spin) nothing += 0.0 * each;
  return body.inverse_mass >= 0.0 && body.inverse_inertia >= 0.0 && body.radius >= 0.0 && nothing >= 0.0;
}

// The impulse along the normal, and that of friction against sliding s, over s; undefined if refused.
function plain_rule_impulse(speed, sliding, friction, ratio, mobility, turning) {
  const found = [];
  plain_rule_at(speed, sliding, friction, ratio, found);
  const slides = Math.abs(sliding) > 0.0;
  const along = slides ? (sliding - found[2]) / ((mobility + turning) * sliding) : 0.0 * found[2];
  return found[1] >= 0.0 ? [((1.0 + found[0]) * speed) / mobility, along] : undefined;
}

export function plain_rule_collide_2d(a, b, normal, friction) {
  const way = plain_rule_direction(normal, 2);
  if (!way || ![a, b].every((each) => plain_rule_is_motion(each, [each.velocity[0], each.velocity[1]], [each.spin]))) return -1;
  const [n, m] = way;
  const x = a.velocity[0] - b.velocity[0], y = a.velocity[1] - b.velocity[1];
  const mobility = a.inverse_mass + b.inverse_mass;
  const arm_a = a.radius * a.inverse_inertia, arm_b = b.radius * b.inverse_inertia;
  const speed = x * n + y * m, sliding = y * n - x * m + a.radius * a.spin + b.radius * b.spin;
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  const turning = a.radius * arm_a + b.radius * arm_b;
  const given = plain_rule_impulse(speed, sliding, friction, b.radius / a.radius, mobility, turning);
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

export function plain_rule_collide_3d(a, b, normal, friction) {
  const way = plain_rule_direction(normal, 3), three = (of) => [of[0], of[1], of[2]];
  if (!way || ![a, b].every((each) => plain_rule_is_motion(each, three(each.velocity), three(each.spin)))) return -1;
  const [n, m, l] = way;
  const [x, y, z] = [0, 1, 2].map((i) => a.velocity[i] - b.velocity[i]);
  const [p, q, r] = [0, 1, 2].map((i) => a.radius * a.spin[i] + b.radius * b.spin[i]);
  const mobility = a.inverse_mass + b.inverse_mass;
  const arm_a = a.radius * a.inverse_inertia, arm_b = b.radius * b.inverse_inertia;
  const speed = x * n + y * m + z * l;
  const u = x - speed * n + (q * l - r * m), v = y - speed * m + (r * n - p * l), w = z - speed * l + (p * m - q * n);
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  const sliding = Math.sqrt(u * u + v * v + w * w), turning = a.radius * arm_a + b.radius * arm_b;
  const given = plain_rule_impulse(speed, sliding, friction, b.radius / a.radius, mobility, turning);
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
