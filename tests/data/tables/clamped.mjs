// Coefficient of restitution of elastic bodies against their speed of approach.
//
//   clamped_restitution(v)        at the speed of approach v, in m/s; its sign does not count
//   clamped_restitution_error(v)  its error, interpolation included: at most 0.00041
//
// Speeds go from CLAMPED_SLOWEST to CLAMPED_FASTEST. Beyond, the coefficient is that at the nearer end,
// and its error Infinity. NaN gives NaN.
//
// A cubic in ln v, monotone where the values are, between values computed at 11 speeds.
//
// stoss
//
// as given

export const CLAMPED_SLOWEST = 0.517219;
export const CLAMPED_FASTEST = 1551.657;

// ln(speed)
const clamped_restitution_speeds = new Float64Array([
  -0.6592888964869599, 0.43932339218114974, 0.9501490159471404, 2.336443377067031,
  2.7419084851751956, 3.9458812895011315, 4.639028470061077, 5.555319201935232, 6.343776562299502,
  6.510830646962668, 7.3470786711632865
]);
// interval in which each of equal parts of it begins
const clamped_restitution_speeds_first = new Int32Array([
  0, 0, 1, 2, 3, 4, 5, 6, 7, 9, 9, 9
]);
// value at each crossing, and its derivatives along the axes
const clamped_restitution_nodes = new Float64Array([
  0.97983005, -0.00030911724136247, 0.97949045, -0.00044145232752464245, 0.9791512499999999,
  -0.0009086558664078906, 0.97662, -0.0027248808756436703, 0.974945, -0.005406850650938565,
  0.9634999999999999, -0.013842031180114716, 0.948, -0.02925483986419392, 0.9075,
  -0.05401759158802182, 0.8534999999999999, -0.062967042475481, 0.8435, 0.0, 0.9199999999999999,
  0.09148003676675631
]);
// of each cell
const clamped_restitution_errors = new Float64Array([
  0.0001103, 0.0001205, 0.000132, 0.00011300000000000001, 0.00013000000000000002,
  0.00015000000000000001, 0.00016, 0.00023, 0.00026000000000000003, 0.00041
]);

// The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
// of values a, b and slopes a', b' at its ends.
function clamped_weigh(x, first, last, bins, at, w) {
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

function clamped_sum_1(a, next, w) {
  const b = a.subarray(next);
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}

function clamped_look_up(x, z, p, found) {
  const w = [], k = [];
  for (let i = 0; i < 1; ++i) w[i] = [0.0, 0.0, 0.0];
  k[0] = clamped_weigh(clamped_restitution_speeds, clamped_restitution_speeds_first, 10, 1.2490058588372874, x, w[0]);
  found[0] = clamped_sum_1(clamped_restitution_nodes.subarray((k[0] * 2)), 2, w[0]);
  found[1] = clamped_restitution_errors[k[0] * 1];
  void z;
  void p;
}

// Restitution and its error; what is not a number where the table says nothing.
function clamped_at(speed, found) {
  let v = Math.abs(speed), p = 0.0;
  const inside = v >= CLAMPED_SLOWEST && v <= CLAMPED_FASTEST;
  if (!inside) {
    found[0] = found[1] = NaN;
    if (!(v >= 0.0)) return;
    found[1] = Infinity;
    if (v < CLAMPED_SLOWEST) v = CLAMPED_SLOWEST;
    if (v > CLAMPED_FASTEST) v = CLAMPED_FASTEST;
  }
  clamped_look_up(Math.log(v), 0.0, p, found);
  if (!inside) found[1] = Infinity;
}

export function clamped_restitution(speed) {
  const found = [];
  clamped_at(speed, found);
  return found[0];
}

export function clamped_restitution_error(speed) {
  const found = [];
  clamped_at(speed, found);
  return found[1];
}
