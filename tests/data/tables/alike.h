/* Coefficient of restitution of two elastic bodies against their speed of approach and the ratio of their radii.
 *
 *   alike_pair_restitution(v, r)        at the speed of approach v, in c; its sign does not count
 *   alike_pair_restitution_error(v, r)  its error, interpolation included: at most 0.0034999999999999996
 *
 * r is the radius of the second body over that of the first; its inverse is the same pair.
 * Speeds go from ALIKE_PAIR_SLOWEST to ALIKE_PAIR_FASTEST, ratios from ALIKE_PAIR_SMALLEST to ALIKE_PAIR_GREATEST.
 * Beyond, the coefficient is that at the nearer end, and its error HUGE_VAL. NaN gives NaN.
 *
 * Values were computed at 6 speeds and 3 ratios.
 */
#ifndef ALIKE_PAIR_RESTITUTION_TABLE
#define ALIKE_PAIR_RESTITUTION_TABLE

#include <math.h>

#if defined(__GNUC__)
#define ALIKE_PAIR_FUNCTION static __inline__ __attribute__((unused))
#elif defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L)
#define ALIKE_PAIR_FUNCTION static inline
#else
#define ALIKE_PAIR_FUNCTION static
#endif
#ifdef __cplusplus
#define ALIKE_PAIR_INDEX(x) static_cast<int>(x)
#else
#define ALIKE_PAIR_INDEX(x) ((int)(x))
#endif

#define ALIKE_PAIR_SLOWEST 0.01
#define ALIKE_PAIR_FASTEST 0.2
#define ALIKE_PAIR_SMALLEST 1.0
#define ALIKE_PAIR_GREATEST 3.0

/* ln(speed) */
static const double alike_pair_speeds[6] = {
  -4.605170185988091, -4.3428059215206005, -3.912023005428146, -2.995732273553991,
  -2.8134107167600364, -1.6094379124341003
};
/* s = (ratio - 1)/(ratio + 1) */
static const double alike_pair_ratios[3] = {
  0.0, 0.2, 0.5
};
/* restitution at each speed for all ratios, its slopes against ln(speed), s, and both */
static const double alike_pair_nodes[18][4] = {
  {0.8502, -0.010908497793359591, 0.0, 0.0},
  {0.8468666666666667, -0.010908497793359591, -0.04111111111111099, 0.0},
  {0.8235333333333333, -0.010908497793359591, -0.11444444444444446, 0.0},
  {0.8473379999999999, -0.012527487279092793, 0.0, 0.0},
  {0.8440046666666666, -0.012527487279092793, -0.04111111111111099, 0.0},
  {0.8206713333333333, -0.012527487279092793, -0.11444444444444446, 0.0},
  {0.8408, -0.019037948734024698, 0.0, 0.0},
  {0.8374666666666667, -0.019037948734024698, -0.04111111111111099, 0.0},
  {0.8141333333333334, -0.019037948734024698, -0.11444444444444446, 0.0},
  {0.815, -0.035596027361620916, 0.0, 0.0},
  {0.8116666666666666, -0.035596027361620916, -0.04111111111111099, 0.0},
  {0.7883333333333333, -0.035596027361620916, -0.11444444444444446, 0.0},
  {0.8072, -0.04691346963516049, 0.0, 0.0},
  {0.8038666666666667, -0.04691346963516049, -0.04111111111111099, 0.0},
  {0.7805333333333334, -0.04691346963516049, -0.11444444444444446, 0.0},
  {0.74, -0.055815214229546536, 0.0, 0.0},
  {0.7366666666666667, -0.055815214229546536, -0.04111111111111099, 0.0},
  {0.7133333333333334, -0.055815214229546536, -0.11444444444444446, 0.0}
};
/* of the restitution between two speeds and two ratios */
static const double alike_pair_errors[5][2] = {
  {0.00326625, 0.00326625},
  {0.003275, 0.003275},
  {0.0033125000000000003, 0.0033125000000000003},
  {0.0033250000000000003, 0.0033250000000000003},
  {0.0034999999999999996, 0.0034999999999999996}
};
/* interval in which each of equal parts of ln(speed) begins */
static const int alike_pair_first_speeds[7] = {
  0, 1, 2, 4, 4, 4, 4
};
/* interval in which each of equal parts of s begins */
static const int alike_pair_first_ratios[4] = {
  0, 1, 1, 1
};

/* Of as many intervals between places x, that in which another one lies. */
ALIKE_PAIR_FUNCTION int alike_pair_interval(const double *x, const int *first, int intervals, double bins, double at)
{
  int k = ALIKE_PAIR_INDEX((at - x[0]) * bins);
  if (k < 0) k = 0;
  if (k > intervals) k = intervals;
  k = first[k];
  while (k + 1 < intervals && at >= x[k + 1]) ++k;
  return k;
}

/* Ratios by their difference over their sum, which changes its sign with the inverse. */
ALIKE_PAIR_FUNCTION double alike_pair_place(double ratio)
{
  const double s = (ratio - 1.0) / (ratio + 1.0);
  return fabs(s);
}

ALIKE_PAIR_FUNCTION int alike_pair_holds(double v, double ratio)
{
  const double s = alike_pair_place(ratio);
  return v >= ALIKE_PAIR_SLOWEST && v <= ALIKE_PAIR_FASTEST && ratio > 0.0 && s >= -1e-15 && s <= 0.500000000000001;
}

ALIKE_PAIR_FUNCTION double alike_pair_within(double v, double s)
{
  const double x = log(v);
  const int k = alike_pair_interval(alike_pair_speeds, alike_pair_first_speeds, 5, 1.6690410034766705, x);
  const int j = alike_pair_interval(alike_pair_ratios, alike_pair_first_ratios, 2, 4.0, s);
  const double (*a)[4] = alike_pair_nodes + k * (2 + 1) + j;
  const double (*b)[4] = a + 2 + 1;
  const double h = alike_pair_speeds[k + 1] - alike_pair_speeds[k];
  const double g = alike_pair_ratios[j + 1] - alike_pair_ratios[j];
  const double t = (x - alike_pair_speeds[k]) / h, u = 1.0 - t;
  const double p = (s - alike_pair_ratios[j]) / g, q = 1.0 - p;
  const double a0 = (1.0 + 2.0 * t) * u * u, b0 = t * t * (1.0 + 2.0 * u), a1 = h * t * u * u, b1 = -h * t * t * u;
  const double left = a0 * a[0][0] + b0 * b[0][0] + a1 * a[0][1] + b1 * b[0][1];
  const double right = a0 * a[1][0] + b0 * b[1][0] + a1 * a[1][1] + b1 * b[1][1];
  const double from = a0 * a[0][2] + b0 * b[0][2] + a1 * a[0][3] + b1 * b[0][3];
  const double to = a0 * a[1][2] + b0 * b[1][2] + a1 * a[1][3] + b1 * b[1][3];
  return left * (1.0 + 2.0 * p) * q * q + right * p * p * (1.0 + 2.0 * q) + g * p * q * (from * q - to * p);
}

ALIKE_PAIR_FUNCTION double alike_pair_restitution(double speed, double ratio)
{
  double v = fabs(speed), s = alike_pair_place(ratio);
  if (alike_pair_holds(v, ratio)) return alike_pair_within(v, s);
  if (!(v >= 0.0)) return v;
  if (!(ratio >= 0.0 || ratio < 0.0)) return ratio;
  if (!(ratio > 0.0)) return HUGE_VAL - HUGE_VAL;
  if (v < ALIKE_PAIR_SLOWEST) v = ALIKE_PAIR_SLOWEST;
  if (v > ALIKE_PAIR_FASTEST) v = ALIKE_PAIR_FASTEST;
  if (s < 0.0) s = 0.0;
  if (!(s <= 0.5)) s = 0.5;
  return alike_pair_within(v, s);
}

ALIKE_PAIR_FUNCTION double alike_pair_restitution_error(double speed, double ratio)
{
  const double v = fabs(speed), s = alike_pair_place(ratio);
  if (!(v >= 0.0)) return v;
  if (!(ratio >= 0.0 || ratio < 0.0)) return ratio;
  if (!alike_pair_holds(v, ratio)) return HUGE_VAL;
  return alike_pair_errors[alike_pair_interval(alike_pair_speeds, alike_pair_first_speeds, 5, 1.6690410034766705, log(v))]
                      [alike_pair_interval(alike_pair_ratios, alike_pair_first_ratios, 2, 4.0, s)];
}

#undef ALIKE_PAIR_FUNCTION
#undef ALIKE_PAIR_INDEX

#endif
