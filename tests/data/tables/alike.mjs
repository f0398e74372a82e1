// Coefficient of restitution of two elastic bodies against their speed of approach and the ratio of their radii.
//
//   alike_pair_restitution(v, r)        at the speed of approach v, in c; its sign does not count
//   alike_pair_restitution_error(v, r)  its error, interpolation included: at most 0.0034999999999999996
//
// r is the radius of the second body over that of the first; its inverse is the same pair.
// Speeds go from ALIKE_PAIR_SLOWEST to ALIKE_PAIR_FASTEST, ratios from ALIKE_PAIR_SMALLEST to ALIKE_PAIR_GREATEST.
// Beyond, the coefficient is that at the nearer end, and its error Infinity. NaN gives NaN.
//
// Values were computed at 6 speeds and 3 ratios.

export const ALIKE_PAIR_SLOWEST = 0.01;
export const ALIKE_PAIR_FASTEST = 0.2;
export const ALIKE_PAIR_SMALLEST = 1.0;
export const ALIKE_PAIR_GREATEST = 3.0;

// ln(speed)
const alike_pair_restitution_speeds = new Float64Array([
  -4.605170185988091, -4.3428059215206005, -3.912023005428146, -2.995732273553991,
  -2.8134107167600364, -1.6094379124341003
]);
// interval in which each of equal parts of it begins
const alike_pair_restitution_speeds_first = new Int32Array([
  0, 1, 2, 4, 4, 4, 4
]);
// (ratio - 1)/(ratio + 1)
const alike_pair_restitution_ratios = new Float64Array([
  0.0, 0.2, 0.5
]);
// interval in which each of equal parts of it begins
const alike_pair_restitution_ratios_first = new Int32Array([
  0, 1, 1, 1
]);
// value at each crossing, and its derivatives along the axes
const alike_pair_restitution_nodes = new Float64Array([
  0.8502, -0.010908497793359591, 0.0, 0.0, 0.8468666666666667, -0.010908497793359591,
  -0.04111111111111099, 0.0, 0.8235333333333333, -0.010908497793359591, -0.11444444444444446, 0.0,
  0.8473379999999999, -0.012527487279092793, 0.0, 0.0, 0.8440046666666666, -0.012527487279092793,
  -0.04111111111111099, 0.0, 0.8206713333333333, -0.012527487279092793, -0.11444444444444446, 0.0,
  0.8408, -0.019037948734024698, 0.0, 0.0, 0.8374666666666667, -0.019037948734024698,
  -0.04111111111111099, 0.0, 0.8141333333333334, -0.019037948734024698, -0.11444444444444446, 0.0,
  0.815, -0.035596027361620916, 0.0, 0.0, 0.8116666666666666, -0.035596027361620916,
  -0.04111111111111099, 0.0, 0.7883333333333333, -0.035596027361620916, -0.11444444444444446, 0.0,
  0.8072, -0.04691346963516049, 0.0, 0.0, 0.8038666666666667, -0.04691346963516049,
  -0.04111111111111099, 0.0, 0.7805333333333334, -0.04691346963516049, -0.11444444444444446, 0.0,
  0.74, -0.055815214229546536, 0.0, 0.0, 0.7366666666666667, -0.055815214229546536,
  -0.04111111111111099, 0.0, 0.7133333333333334, -0.055815214229546536, -0.11444444444444446, 0.0
]);
// of each cell
const alike_pair_restitution_errors = new Float64Array([
  0.00326625, 0.00326625, 0.003275, 0.003275, 0.0033125000000000003, 0.0033125000000000003,
  0.0033250000000000003, 0.0033250000000000003, 0.0034999999999999996, 0.0034999999999999996
]);

// The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
// of values a, b and slopes a', b' at its ends.
function alike_pair_weigh(x, first, last, bins, at, w) {
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

function alike_pair_sum_1(a, next, w) {
  const b = a.subarray(next);
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}

function alike_pair_sum_2(a, next, line, w, y) {
  const b = a.subarray(line);
  const begin = alike_pair_sum_1(a, next, w), end = alike_pair_sum_1(b, next, w);
  return begin + y[0] * (end - begin) + y[1] * alike_pair_sum_1(a.subarray(2), next, w) - y[2] * alike_pair_sum_1(b.subarray(2), next, w);
}

function alike_pair_look_up(x, z, p, found) {
  const w = [], k = [];
  for (let i = 0; i < 2; ++i) w[i] = [0.0, 0.0, 0.0];
  k[0] = alike_pair_weigh(alike_pair_restitution_speeds, alike_pair_restitution_speeds_first, 5, 1.6690410034766705, x, w[0]);
  k[1] = alike_pair_weigh(alike_pair_restitution_ratios, alike_pair_restitution_ratios_first, 2, 4.0, p, w[1]);
  found[0] = alike_pair_sum_2(alike_pair_restitution_nodes.subarray((k[0] * 12 + k[1] * 4)), 12, 4, w[0], w[1]);
  found[1] = alike_pair_restitution_errors[k[0] * 2 + k[1] * 1];
  void z;
  void p;
}

// Restitution and its error; what is not a number where the table says nothing.
function alike_pair_at(speed, ratio, found) {
  let v = Math.abs(speed), p = Math.abs((ratio - 1.0) / (ratio + 1.0));
  const inside = v >= ALIKE_PAIR_SLOWEST && v <= ALIKE_PAIR_FASTEST && p >= -1e-15 && p <= 0.500000000000001;
  if (!inside) {
    found[0] = found[1] = NaN;
    if (!(v >= 0.0) || !(ratio >= 0.0 || ratio < 0.0)) return;
    found[1] = Infinity;
    if (!(ratio > 0.0)) return;
    if (v < ALIKE_PAIR_SLOWEST) v = ALIKE_PAIR_SLOWEST;
    if (v > ALIKE_PAIR_FASTEST) v = ALIKE_PAIR_FASTEST;
    if (!(p < 0.5)) p = 0.5;
    if (p < 0.0) p = 0.0;
  }
  alike_pair_look_up(Math.log(v), 0.0, p, found);
  if (!inside) found[1] = Infinity;
}

export function alike_pair_restitution(speed, ratio) {
  const found = [];
  alike_pair_at(speed, ratio, found);
  return found[0];
}

export function alike_pair_restitution_error(speed, ratio) {
  const found = [];
  alike_pair_at(speed, ratio, found);
  return found[1];
}
