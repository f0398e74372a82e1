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

/* ln(speed), restitution, its slope against ln(speed) */
static const double clamped_knots[11][3] = {
  {-0.6592888964869599, 0.97983005, -0.00030911724136247},
  {0.43932339218114974, 0.97949045, -0.00044145232752464245},
  {0.9501490159471404, 0.9791512499999999, -0.0009086558664078906},
  {2.336443377067031, 0.97662, -0.0027248808756436703},
  {2.7419084851751956, 0.974945, -0.005406850650938565},
  {3.9458812895011315, 0.9634999999999999, -0.013842031180114716},
  {4.639028470061077, 0.948, -0.02925483986419392},
  {5.555319201935232, 0.9075, -0.05401759158802182},
  {6.343776562299502, 0.8534999999999999, -0.062967042475481},
  {6.510830646962668, 0.8435, 0.0},
  {7.3470786711632865, 0.9199999999999999, 0.09148003676675631}
};
/* of the restitution, between a knot and the next */
static const double clamped_errors[10] = {
  0.0001103, 0.0001205, 0.000132, 0.00011300000000000001, 0.00013000000000000002,
  0.00015000000000000001, 0.00016, 0.00023, 0.00026000000000000003, 0.00041
};
/* interval in which each of as many equal parts of ln(speed) begins */
static const int clamped_first[10] = {
  0, 0, 1, 2, 3, 4, 5, 6, 7, 9
};

/* The interval between knots that ln(speed) lies in. */
CLAMPED_FUNCTION int clamped_interval(double x)
{
  int k = CLAMPED_INDEX((x - -0.6592888964869599) * 1.2490058588372874);
  if (k < 0) k = 0;
  if (k > 9) k = 9;
  k = clamped_first[k];
  while (k > 0 && x < clamped_knots[k][0]) --k;
  while (k < 9 && x >= clamped_knots[k + 1][0]) ++k;
  return k;
}

CLAMPED_FUNCTION double clamped_restitution(double speed)
{
  const double v = fabs(speed);
  const double *a, *b;
  double x, h, t, u;
  int k;
  if (!(v >= CLAMPED_SLOWEST)) return v < CLAMPED_SLOWEST ? 0.97983005 : v;
  if (v > CLAMPED_FASTEST) return 0.9199999999999999;
  x = log(v);
  k = clamped_interval(x);
  a = clamped_knots[k];
  b = clamped_knots[k + 1];
  h = b[0] - a[0];
  t = (x - a[0]) / h;
  u = 1.0 - t;
  return a[1] * (1.0 + 2.0 * t) * u * u + b[1] * t * t * (1.0 + 2.0 * u) + h * t * u * (a[2] * u - b[2] * t);
}

CLAMPED_FUNCTION double clamped_restitution_error(double speed)
{
  const double v = fabs(speed);
  if (v >= CLAMPED_SLOWEST && v <= CLAMPED_FASTEST) return clamped_errors[clamped_interval(log(v))];
  return v >= 0.0 ? HUGE_VAL : v;
}

#undef CLAMPED_FUNCTION
#undef CLAMPED_INDEX

#endif
