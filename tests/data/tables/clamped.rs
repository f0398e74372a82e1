// Coefficient of restitution of elastic bodies against their speed of approach.
//
//   clamped_restitution(v)        at the speed of approach v, in m/s; its sign does not count
//   clamped_restitution_error(v)  its error, interpolation included: at most 0.00041
//
// Speeds go from CLAMPED_SLOWEST to CLAMPED_FASTEST. Beyond, the coefficient is that at the nearer end,
// and its error f64::INFINITY. NaN gives NaN.
//
// A cubic in ln v, monotone where the values are, between values computed at 11 speeds.
//
// stoss
//
// as given

#[allow(dead_code)]
pub const CLAMPED_SLOWEST: f64 = 0.517219;
#[allow(dead_code)]
pub const CLAMPED_FASTEST: f64 = 1551.657;

// ln(speed)
#[allow(non_upper_case_globals)]
static clamped_restitution_speeds: [f64; 11] = [
  -0.6592888964869599, 0.43932339218114974, 0.9501490159471404, 2.336443377067031,
  2.7419084851751956, 3.9458812895011315, 4.639028470061077, 5.555319201935232, 6.343776562299502,
  6.510830646962668, 7.3470786711632865
];
// interval in which each of equal parts of it begins
#[allow(non_upper_case_globals)]
static clamped_restitution_speeds_first: [usize; 12] = [
  0, 0, 1, 2, 3, 4, 5, 6, 7, 9, 9, 9
];
// value at each crossing, and its derivatives along the axes
#[allow(non_upper_case_globals)]
static clamped_restitution_nodes: [f64; 22] = [
  0.97983005, -0.00030911724136247, 0.97949045, -0.00044145232752464245, 0.9791512499999999,
  -0.0009086558664078906, 0.97662, -0.0027248808756436703, 0.974945, -0.005406850650938565,
  0.9634999999999999, -0.013842031180114716, 0.948, -0.02925483986419392, 0.9075,
  -0.05401759158802182, 0.8534999999999999, -0.062967042475481, 0.8435, 0.0, 0.9199999999999999,
  0.09148003676675631
];
// of each cell
#[allow(non_upper_case_globals)]
static clamped_restitution_errors: [f64; 10] = [
  0.0001103, 0.0001205, 0.000132, 0.00011300000000000001, 0.00013000000000000002,
  0.00015000000000000001, 0.00016, 0.00023, 0.00026000000000000003, 0.00041
];

// The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
// of values a, b and slopes a', b' at its ends.
#[allow(non_snake_case)]
fn clamped_weigh(x: &[f64], first: &[usize], last: usize, bins: f64, at: f64, w: &mut [f64]) -> usize {
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
fn clamped_sum_1(a: &[f64], next: usize, w: &[f64]) -> f64 {
  let b = &a[next..];
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}

#[allow(non_snake_case, unused_mut)]
fn clamped_look_up(x: f64, z: f64, p: f64, found: &mut [f64]) {
  let mut w = [[0.0; 3]; 1];
  let mut k = [0; 1];
  k[0] = clamped_weigh(&clamped_restitution_speeds, &clamped_restitution_speeds_first, 10, 1.2490058588372874, x, &mut w[0]);
  found[0] = clamped_sum_1(&clamped_restitution_nodes[(k[0] * 2)..], 2, &w[0]);
  found[1] = clamped_restitution_errors[k[0] * 1];
  let _ = z;
  let _ = p;
}

// Restitution and its error; what is not a number where the table says nothing.
#[allow(non_snake_case, unused_mut)]
fn clamped_at(speed: f64, found: &mut [f64]) {
  let mut v = f64::abs(speed);
  let mut p = 0.0;
  let inside = v >= CLAMPED_SLOWEST && v <= CLAMPED_FASTEST;
  if !inside {
    found[0] = f64::NAN;
    found[1] = f64::NAN;
    if !(v >= 0.0) { return; }
    found[1] = f64::INFINITY;
    if v < CLAMPED_SLOWEST { v = CLAMPED_SLOWEST; }
    if v > CLAMPED_FASTEST { v = CLAMPED_FASTEST; }
  }
  clamped_look_up(f64::ln(v), 0.0, p, found);
  if !inside { found[1] = f64::INFINITY; }
}

#[allow(dead_code, non_snake_case)]
pub fn clamped_restitution(speed: f64) -> f64 {
  let mut found = [0.0; 2];
  clamped_at(speed, &mut found);
  return found[0];
}

#[allow(dead_code, non_snake_case)]
pub fn clamped_restitution_error(speed: f64) -> f64 {
  let mut found = [0.0; 2];
  clamped_at(speed, &mut found);
  return found[1];
}
