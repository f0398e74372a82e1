/* Coefficient of restitution against the speed of approach, with yield and adhesion as models.
 *
 *   strict_restitution(v)        at the speed of approach v, in c; its sign does not count
 *   strict_restitution_error(v)  its error, interpolation included: at most 0.00041
 *
 * That error is of computation and interpolation alone. Beside it stand the spread of the
 * models, which differ from the coefficient by up to 0.013, and the uncertainty of the constants:
 * stoss predict says both for each speed.
 *
 * Speeds go from STRICT_SLOWEST to STRICT_FASTEST. Beyond, the coefficient is not a number,
 * and its error HUGE_VAL. NaN gives NaN.
 *
 * A cubic in ln v, monotone where the values are, between values computed at 11 speeds.
 */
#ifndef STRICT_RESTITUTION_TABLE
#define STRICT_RESTITUTION_TABLE

#include <math.h>

#if defined(__GNUC__)
#define STRICT_FUNCTION static __inline__ __attribute__((unused))
#elif defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L)
#define STRICT_FUNCTION static inline
#else
#define STRICT_FUNCTION static
#endif
#ifdef __cplusplus
#define STRICT_INDEX(x) static_cast<int>(x)
#else
#define STRICT_INDEX(x) ((int)(x))
#endif

#define STRICT_SLOWEST 0.0001
#define STRICT_FASTEST 0.3

/* ln(speed), restitution, its slope against ln(speed) */
static const double strict_knots[11][3] = {
  {-9.210340371976182, 0.97983005, -0.00030911724136247},
  {-8.111728083308073, 0.97949045, -0.00044145232752464245},
  {-7.600902459542082, 0.9791512499999999, -0.0009086558664078906},
  {-6.214608098422191, 0.97662, -0.0027248808756436703},
  {-5.809142990314028, 0.974945, -0.005406850650938565},
  {-4.605170185988091, 0.9634999999999999, -0.013842031180114716},
  {-3.912023005428146, 0.948, -0.02925483986419392},
  {-2.995732273553991, 0.9075, -0.05401759158802182},
  {-2.2072749131897207, 0.8534999999999999, -0.062967042475481},
  {-2.0402208285265546, 0.8435, 0.0},
  {-1.2039728043259361, 0.9199999999999999, 0.09148003676675631}
};
/* of the restitution, between a knot and the next */
static const double strict_errors[10] = {
  0.0001103, 0.0001205, 0.000132, 0.00011300000000000001, 0.00013000000000000002,
  0.00015000000000000001, 0.00016, 0.00023, 0.00026000000000000003, 0.00041
};
/* interval in which each of as many equal parts of ln(speed) begins */
static const int strict_first[10] = {
  0, 0, 1, 2, 3, 4, 5, 6, 7, 9
};

/* The interval between knots that ln(speed) lies in. */
STRICT_FUNCTION int strict_interval(double x)
{
  int k = STRICT_INDEX((x - -9.210340371976182) * 1.2490058588372874);
  if (k < 0) k = 0;
  if (k > 9) k = 9;
  k = strict_first[k];
  while (k > 0 && x < strict_knots[k][0]) --k;
  while (k < 9 && x >= strict_knots[k + 1][0]) ++k;
  return k;
}

STRICT_FUNCTION double strict_restitution(double speed)
{
  const double v = fabs(speed);
  const double *a, *b;
  double x, h, t, u;
  int k;
  if (!(v >= STRICT_SLOWEST)) return v < STRICT_SLOWEST ? HUGE_VAL - HUGE_VAL : v;
  if (v > STRICT_FASTEST) return HUGE_VAL - HUGE_VAL;
  x = log(v);
  k = strict_interval(x);
  a = strict_knots[k];
  b = strict_knots[k + 1];
  h = b[0] - a[0];
  t = (x - a[0]) / h;
  u = 1.0 - t;
  return a[1] * (1.0 + 2.0 * t) * u * u + b[1] * t * t * (1.0 + 2.0 * u) + h * t * u * (a[2] * u - b[2] * t);
}

STRICT_FUNCTION double strict_restitution_error(double speed)
{
  const double v = fabs(speed);
  if (v >= STRICT_SLOWEST && v <= STRICT_FASTEST) return strict_errors[strict_interval(log(v))];
  return v >= 0.0 ? HUGE_VAL : v;
}

#undef STRICT_FUNCTION
#undef STRICT_INDEX

#endif
