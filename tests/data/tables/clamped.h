/* Coefficient of restitution of elastic bodies against their speed of approach.
 *
 *   clamped_restitution(v)        at the speed of approach v, in m/s; its sign does not count
 *   clamped_restitution_error(v)  its error, interpolation included: at most 0.00041
 *
 * Speeds go from CLAMPED_SLOWEST to CLAMPED_FASTEST. Beyond, the coefficient is that at the nearer end,
 * and its error HUGE_VAL. NaN gives NaN.
 *
 * A cubic in ln v, monotone where the values are, between values computed at 11 speeds.
 *
 * stoss
 *
 * as given
 */
#ifndef CLAMPED_RESTITUTION_TABLE
#define CLAMPED_RESTITUTION_TABLE

#include <math.h>

#if defined(__GNUC__)
#define CLAMPED_FUNCTION static __inline__ __attribute__((unused))
#elif defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L)
#define CLAMPED_FUNCTION static inline
#else
#define CLAMPED_FUNCTION static
#endif
#ifdef __cplusplus
#define CLAMPED_INDEX(x) static_cast<int>(x)
#else
#define CLAMPED_INDEX(x) ((int)(x))
#endif

#define CLAMPED_SLOWEST 0.517219
#define CLAMPED_FASTEST 1551.657

/* ln(speed) */
static const double clamped_restitution_speeds[11] = {
  -0.6592888964869599, 0.43932339218114974, 0.9501490159471404, 2.336443377067031,
  2.7419084851751956, 3.9458812895011315, 4.639028470061077, 5.555319201935232, 6.343776562299502,
  6.510830646962668, 7.3470786711632865
};
/* interval in which each of equal parts of it begins */
static const int clamped_restitution_speeds_first[12] = {
  0, 0, 1, 2, 3, 4, 5, 6, 7, 9, 9, 9
};
/* value at each crossing, and its derivatives along the axes */
static const double clamped_restitution_nodes[22] = {
  0.97983005, -0.00030911724136247, 0.97949045, -0.00044145232752464245, 0.9791512499999999,
  -0.0009086558664078906, 0.97662, -0.0027248808756436703, 0.974945, -0.005406850650938565,
  0.9634999999999999, -0.013842031180114716, 0.948, -0.02925483986419392, 0.9075,
  -0.05401759158802182, 0.8534999999999999, -0.062967042475481, 0.8435, 0.0, 0.9199999999999999,
  0.09148003676675631
};
/* of each cell */
static const double clamped_restitution_errors[10] = {
  0.0001103, 0.0001205, 0.000132, 0.00011300000000000001, 0.00013000000000000002,
  0.00015000000000000001, 0.00016, 0.00023, 0.00026000000000000003, 0.00041
};

/* The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
 * of values a, b and slopes a', b' at its ends. */
CLAMPED_FUNCTION int clamped_weigh(const double *x, const int *first, int last, double bins, double at, double *w)
{
  double h, t, u;
  int k;
  k = CLAMPED_INDEX((at - x[0]) * bins);
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

CLAMPED_FUNCTION double clamped_sum_1(const double *a, int next, const double *w)
{
  const double *b = a + next;
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}

CLAMPED_FUNCTION void clamped_look_up(double x, double z, double p, double *found)
{
  double w[1][3];
  int k[1];
  k[0] = clamped_weigh(clamped_restitution_speeds, clamped_restitution_speeds_first, 10, 1.2490058588372874, x, w[0]);
  found[0] = clamped_sum_1(clamped_restitution_nodes + (k[0] * 2), 2, w[0]);
  found[1] = clamped_restitution_errors[k[0] * 1];
  (void)z;
  (void)p;
}

/* Restitution and its error; what is not a number where the table says nothing. */
CLAMPED_FUNCTION void clamped_at(double speed, double *found)
{
  double v = fabs(speed), p = 0.0;
  const int inside = v >= CLAMPED_SLOWEST && v <= CLAMPED_FASTEST;
  if (!inside) {
    found[0] = found[1] = HUGE_VAL - HUGE_VAL;
    if (!(v >= 0.0)) return;
    found[1] = HUGE_VAL;
    if (v < CLAMPED_SLOWEST) v = CLAMPED_SLOWEST;
    if (v > CLAMPED_FASTEST) v = CLAMPED_FASTEST;
  }
  clamped_look_up(log(v), 0.0, p, found);
  if (!inside) found[1] = HUGE_VAL;
}

CLAMPED_FUNCTION double clamped_restitution(double speed)
{
  double found[2];
  clamped_at(speed, found);
  return found[0];
}

CLAMPED_FUNCTION double clamped_restitution_error(double speed)
{
  double found[2];
  clamped_at(speed, found);
  return found[1];
}

#undef CLAMPED_FUNCTION
#undef CLAMPED_INDEX

#endif
