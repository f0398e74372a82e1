/* Coefficient of restitution of two elastic bodies against their speed of approach and the ratio of their radii.
 *
 *   unequal_pair_restitution(v, r)        at the speed of approach v, in m/s; its sign does not count
 *   unequal_pair_restitution_error(v, r)  its error, interpolation included: at most 0.0034999999999999996
 *
 * r is the radius of the second body over that of the first.
 * Speeds go from UNEQUAL_PAIR_SLOWEST to UNEQUAL_PAIR_FASTEST, ratios from UNEQUAL_PAIR_SMALLEST to UNEQUAL_PAIR_GREATEST.
 * Beyond, the coefficient is not a number, and its error HUGE_VAL. NaN gives NaN.
 *
 * Values were computed at 6 speeds and 6 ratios.
 *
 * stoss
 *
 * as given
 */
#ifndef UNEQUAL_PAIR_RESTITUTION_TABLE
#define UNEQUAL_PAIR_RESTITUTION_TABLE

#include <math.h>

#if defined(__GNUC__)
#define UNEQUAL_PAIR_FUNCTION static __inline__ __attribute__((unused))
#elif defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L)
#define UNEQUAL_PAIR_FUNCTION static inline
#else
#define UNEQUAL_PAIR_FUNCTION static
#endif
#ifdef __cplusplus
#define UNEQUAL_PAIR_INDEX(x) static_cast<int>(x)
#else
#define UNEQUAL_PAIR_INDEX(x) ((int)(x))
#endif

#define UNEQUAL_PAIR_SLOWEST 51.7219
#define UNEQUAL_PAIR_FASTEST 1034.438
#define UNEQUAL_PAIR_SMALLEST 0.5
#define UNEQUAL_PAIR_GREATEST 7.0

/* ln(speed) */
static const double unequal_pair_speeds[6] = {
  3.9458812895011315, 4.208245553968623, 4.639028470061077, 5.555319201935232, 5.737640758729186,
  6.941613563055123
};
/* s = (ratio - 1)/(ratio + 1) */
static const double unequal_pair_ratios[6] = {
  -0.3333333333333333, -0.25, -0.05263157894736841, 0.13043478260869568, 0.3333333333333333, 0.75
};
/* restitution at each speed for all ratios, its slopes against ln(speed), s, and both */
static const double unequal_pair_nodes[36][4] = {
  {0.8402, -0.010908497793359591, 0.06493703703703776, 0.0},
  {0.8448666666666667, -0.010908497793359591, 0.04706296296296325, 0.0},
  {0.8499777777777777, -0.010908497793359591, 0.009167236467236585, 0.0},
  {0.8488153846153846, -0.010908497793359591, -0.023477777777777733, 0.0},
  {0.8402, -0.010908497793359591, -0.1015384615384618, 0.0},
  {0.7473428571428571, -0.010908497793359591, -0.34417582417582393, 0.0},
  {0.8373379999999999, -0.012527487279092793, 0.06493703703703776, 0.0},
  {0.8420046666666666, -0.012527487279092793, 0.04706296296296325, 0.0},
  {0.8471157777777777, -0.012527487279092793, 0.009167236467236585, 0.0},
  {0.8459533846153846, -0.012527487279092793, -0.023477777777777733, 0.0},
  {0.8373379999999999, -0.012527487279092793, -0.1015384615384618, 0.0},
  {0.744480857142857, -0.012527487279092793, -0.34417582417582393, 0.0},
  {0.8308, -0.019037948734024698, 0.06493703703703776, 0.0},
  {0.8354666666666667, -0.019037948734024698, 0.04706296296296325, 0.0},
  {0.8405777777777778, -0.019037948734024698, 0.009167236467236585, 0.0},
  {0.8394153846153847, -0.019037948734024698, -0.023477777777777733, 0.0},
  {0.8308, -0.019037948734024698, -0.1015384615384618, 0.0},
  {0.7379428571428571, -0.019037948734024698, -0.34417582417582393, 0.0},
  {0.8049999999999999, -0.035596027361620916, 0.06493703703703776, 0.0},
  {0.8096666666666666, -0.035596027361620916, 0.04706296296296325, 0.0},
  {0.8147777777777777, -0.035596027361620916, 0.009167236467236585, 0.0},
  {0.8136153846153846, -0.035596027361620916, -0.023477777777777733, 0.0},
  {0.8049999999999999, -0.035596027361620916, -0.1015384615384618, 0.0},
  {0.7121428571428571, -0.035596027361620916, -0.34417582417582393, 0.0},
  {0.7972, -0.04691346963516049, 0.06493703703703776, 0.0},
  {0.8018666666666667, -0.04691346963516049, 0.04706296296296325, 0.0},
  {0.8069777777777778, -0.04691346963516049, 0.009167236467236585, 0.0},
  {0.8058153846153847, -0.04691346963516049, -0.023477777777777733, 0.0},
  {0.7972, -0.04691346963516049, -0.1015384615384618, 0.0},
  {0.7043428571428572, -0.04691346963516049, -0.34417582417582393, 0.0},
  {0.73, -0.055815214229546536, 0.06493703703703776, 0.0},
  {0.7346666666666667, -0.055815214229546536, 0.04706296296296325, 0.0},
  {0.7397777777777778, -0.055815214229546536, 0.009167236467236585, 0.0},
  {0.7386153846153847, -0.055815214229546536, -0.023477777777777733, 0.0},
  {0.73, -0.055815214229546536, -0.1015384615384618, 0.0},
  {0.6371428571428571, -0.055815214229546536, -0.34417582417582393, 0.0}
};
/* of the restitution between two speeds and two ratios */
static const double unequal_pair_errors[5][5] = {
  {0.00326625, 0.00326625, 0.00326625, 0.00326625, 0.00326625},
  {0.003275, 0.003275, 0.003275, 0.003275, 0.003275},
  {0.0033125000000000003, 0.0033125000000000003, 0.0033125000000000003, 0.0033125000000000003, 0.0033125000000000003},
  {0.0033250000000000003, 0.0033250000000000003, 0.0033250000000000003, 0.0033250000000000003, 0.0033250000000000003},
  {0.0034999999999999996, 0.0034999999999999996, 0.0034999999999999996, 0.0034999999999999996, 0.0034999999999999996}
};
/* interval in which each of equal parts of ln(speed) begins */
static const int unequal_pair_first_speeds[7] = {
  0, 1, 2, 4, 4, 4, 4
};
/* interval in which each of equal parts of s begins */
static const int unequal_pair_first_ratios[7] = {
  0, 1, 2, 3, 4, 4, 4
};

/* Of as many intervals between places x, that in which another one lies. */
UNEQUAL_PAIR_FUNCTION int unequal_pair_interval(const double *x, const int *first, int intervals, double bins, double at)
{
  int k = UNEQUAL_PAIR_INDEX((at - x[0]) * bins);
  if (k < 0) k = 0;
  if (k > intervals) k = intervals;
  k = first[k];
  while (k + 1 < intervals && at >= x[k + 1]) ++k;
  return k;
}

/* Ratios by their difference over their sum, which changes its sign with the inverse. */
UNEQUAL_PAIR_FUNCTION double unequal_pair_place(double ratio)
{
  const double s = (ratio - 1.0) / (ratio + 1.0);
  return s;
}

UNEQUAL_PAIR_FUNCTION int unequal_pair_holds(double v, double ratio)
{
  const double s = unequal_pair_place(ratio);
  return v >= UNEQUAL_PAIR_SLOWEST && v <= UNEQUAL_PAIR_FASTEST && ratio > 0.0 && s >= -0.3333333333333343 && s <= 0.750000000000001;
}

UNEQUAL_PAIR_FUNCTION double unequal_pair_within(double v, double s)
{
  const double x = log(v);
  const int k = unequal_pair_interval(unequal_pair_speeds, unequal_pair_first_speeds, 5, 1.66904100347667, x);
  const int j = unequal_pair_interval(unequal_pair_ratios, unequal_pair_first_ratios, 5, 4.615384615384616, s);
  const double (*a)[4] = unequal_pair_nodes + k * (5 + 1) + j;
  const double (*b)[4] = a + 5 + 1;
  const double h = unequal_pair_speeds[k + 1] - unequal_pair_speeds[k];
  const double g = unequal_pair_ratios[j + 1] - unequal_pair_ratios[j];
  const double t = (x - unequal_pair_speeds[k]) / h, u = 1.0 - t;
  const double p = (s - unequal_pair_ratios[j]) / g, q = 1.0 - p;
  const double a0 = (1.0 + 2.0 * t) * u * u, b0 = t * t * (1.0 + 2.0 * u), a1 = h * t * u * u, b1 = -h * t * t * u;
  const double left = a0 * a[0][0] + b0 * b[0][0] + a1 * a[0][1] + b1 * b[0][1];
  const double right = a0 * a[1][0] + b0 * b[1][0] + a1 * a[1][1] + b1 * b[1][1];
  const double from = a0 * a[0][2] + b0 * b[0][2] + a1 * a[0][3] + b1 * b[0][3];
  const double to = a0 * a[1][2] + b0 * b[1][2] + a1 * a[1][3] + b1 * b[1][3];
  return left * (1.0 + 2.0 * p) * q * q + right * p * p * (1.0 + 2.0 * q) + g * p * q * (from * q - to * p);
}

UNEQUAL_PAIR_FUNCTION double unequal_pair_restitution(double speed, double ratio)
{
  double v = fabs(speed), s = unequal_pair_place(ratio);
  if (unequal_pair_holds(v, ratio)) return unequal_pair_within(v, s);
  if (!(v >= 0.0)) return v;
  if (!(ratio >= 0.0 || ratio < 0.0)) return ratio;
  return HUGE_VAL - HUGE_VAL;
}

UNEQUAL_PAIR_FUNCTION double unequal_pair_restitution_error(double speed, double ratio)
{
  const double v = fabs(speed), s = unequal_pair_place(ratio);
  if (!(v >= 0.0)) return v;
  if (!(ratio >= 0.0 || ratio < 0.0)) return ratio;
  if (!unequal_pair_holds(v, ratio)) return HUGE_VAL;
  return unequal_pair_errors[unequal_pair_interval(unequal_pair_speeds, unequal_pair_first_speeds, 5, 1.66904100347667, log(v))]
                      [unequal_pair_interval(unequal_pair_ratios, unequal_pair_first_ratios, 5, 4.615384615384616, s)];
}

#undef UNEQUAL_PAIR_FUNCTION
#undef UNEQUAL_PAIR_INDEX

#endif
