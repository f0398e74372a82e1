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
static const double unequal_pair_restitution_speeds[6] = {
  3.9458812895011315, 4.208245553968623, 4.639028470061077, 5.555319201935232, 5.737640758729186,
  6.941613563055123
};
/* interval in which each of equal parts of it begins */
static const int unequal_pair_restitution_speeds_first[7] = {
  0, 1, 2, 4, 4, 4, 4
};
/* (ratio - 1)/(ratio + 1) */
static const double unequal_pair_restitution_ratios[6] = {
  -0.3333333333333333, -0.25, -0.05263157894736841, 0.13043478260869568, 0.3333333333333333, 0.75
};
/* interval in which each of equal parts of it begins */
static const int unequal_pair_restitution_ratios_first[7] = {
  0, 1, 2, 3, 4, 4, 4
};
/* value at each crossing, and its derivatives along the axes */
static const double unequal_pair_restitution_nodes[144] = {
  0.8402, -0.010908497793359591, 0.06493703703703776, 0.0, 0.8448666666666667,
  -0.010908497793359591, 0.04706296296296325, 0.0, 0.8499777777777777, -0.010908497793359591,
  0.009167236467236585, 0.0, 0.8488153846153846, -0.010908497793359591, -0.023477777777777733, 0.0,
  0.8402, -0.010908497793359591, -0.1015384615384618, 0.0, 0.7473428571428571,
  -0.010908497793359591, -0.34417582417582393, 0.0, 0.8373379999999999, -0.012527487279092793,
  0.06493703703703776, 0.0, 0.8420046666666666, -0.012527487279092793, 0.04706296296296325, 0.0,
  0.8471157777777777, -0.012527487279092793, 0.009167236467236585, 0.0, 0.8459533846153846,
  -0.012527487279092793, -0.023477777777777733, 0.0, 0.8373379999999999, -0.012527487279092793,
  -0.1015384615384618, 0.0, 0.744480857142857, -0.012527487279092793, -0.34417582417582393, 0.0,
  0.8308, -0.019037948734024698, 0.06493703703703776, 0.0, 0.8354666666666667,
  -0.019037948734024698, 0.04706296296296325, 0.0, 0.8405777777777778, -0.019037948734024698,
  0.009167236467236585, 0.0, 0.8394153846153847, -0.019037948734024698, -0.023477777777777733, 0.0,
  0.8308, -0.019037948734024698, -0.1015384615384618, 0.0, 0.7379428571428571,
  -0.019037948734024698, -0.34417582417582393, 0.0, 0.8049999999999999, -0.035596027361620916,
  0.06493703703703776, 0.0, 0.8096666666666666, -0.035596027361620916, 0.04706296296296325, 0.0,
  0.8147777777777777, -0.035596027361620916, 0.009167236467236585, 0.0, 0.8136153846153846,
  -0.035596027361620916, -0.023477777777777733, 0.0, 0.8049999999999999, -0.035596027361620916,
  -0.1015384615384618, 0.0, 0.7121428571428571, -0.035596027361620916, -0.34417582417582393, 0.0,
  0.7972, -0.04691346963516049, 0.06493703703703776, 0.0, 0.8018666666666667, -0.04691346963516049,
  0.04706296296296325, 0.0, 0.8069777777777778, -0.04691346963516049, 0.009167236467236585, 0.0,
  0.8058153846153847, -0.04691346963516049, -0.023477777777777733, 0.0, 0.7972,
  -0.04691346963516049, -0.1015384615384618, 0.0, 0.7043428571428572, -0.04691346963516049,
  -0.34417582417582393, 0.0, 0.73, -0.055815214229546536, 0.06493703703703776, 0.0,
  0.7346666666666667, -0.055815214229546536, 0.04706296296296325, 0.0, 0.7397777777777778,
  -0.055815214229546536, 0.009167236467236585, 0.0, 0.7386153846153847, -0.055815214229546536,
  -0.023477777777777733, 0.0, 0.73, -0.055815214229546536, -0.1015384615384618, 0.0,
  0.6371428571428571, -0.055815214229546536, -0.34417582417582393, 0.0
};
/* of each cell */
static const double unequal_pair_restitution_errors[25] = {
  0.00326625, 0.00326625, 0.00326625, 0.00326625, 0.00326625, 0.003275, 0.003275, 0.003275,
  0.003275, 0.003275, 0.0033125000000000003, 0.0033125000000000003, 0.0033125000000000003,
  0.0033125000000000003, 0.0033125000000000003, 0.0033250000000000003, 0.0033250000000000003,
  0.0033250000000000003, 0.0033250000000000003, 0.0033250000000000003, 0.0034999999999999996,
  0.0034999999999999996, 0.0034999999999999996, 0.0034999999999999996, 0.0034999999999999996
};

/* The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
 * of values a, b and slopes a', b' at its ends. */
UNEQUAL_PAIR_FUNCTION int unequal_pair_weigh(const double *x, const int *first, int last, double bins, double at, double *w)
{
  double h, t, u;
  int k;
  k = UNEQUAL_PAIR_INDEX((at - x[0]) * bins);
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

UNEQUAL_PAIR_FUNCTION double unequal_pair_sum_1(const double *a, int next, const double *w)
{
  const double *b = a + next;
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}

UNEQUAL_PAIR_FUNCTION double unequal_pair_sum_2(const double *a, int next, int line, const double *w, const double *y)
{
  const double *b = a + line;
  const double begin = unequal_pair_sum_1(a, next, w), end = unequal_pair_sum_1(b, next, w);
  return begin + y[0] * (end - begin) + y[1] * unequal_pair_sum_1(a + 2, next, w) - y[2] * unequal_pair_sum_1(b + 2, next, w);
}

UNEQUAL_PAIR_FUNCTION void unequal_pair_look_up(double x, double z, double p, double *found)
{
  double w[2][3];
  int k[2];
  k[0] = unequal_pair_weigh(unequal_pair_restitution_speeds, unequal_pair_restitution_speeds_first, 5, 1.66904100347667, x, w[0]);
  k[1] = unequal_pair_weigh(unequal_pair_restitution_ratios, unequal_pair_restitution_ratios_first, 5, 4.615384615384616, p, w[1]);
  found[0] = unequal_pair_sum_2(unequal_pair_restitution_nodes + (k[0] * 24 + k[1] * 4), 24, 4, w[0], w[1]);
  found[1] = unequal_pair_restitution_errors[k[0] * 5 + k[1] * 1];
  (void)z;
  (void)p;
}

/* Restitution and its error; what is not a number where the table says nothing. */
UNEQUAL_PAIR_FUNCTION void unequal_pair_at(double speed, double ratio, double *found)
{
  double v = fabs(speed), p = (ratio - 1.0) / (ratio + 1.0);
  const int inside = v >= UNEQUAL_PAIR_SLOWEST && v <= UNEQUAL_PAIR_FASTEST && p >= -0.3333333333333343 && p <= 0.750000000000001;
  if (!inside) {
    found[0] = found[1] = HUGE_VAL - HUGE_VAL;
    if (!(v >= 0.0) || !(ratio >= 0.0 || ratio < 0.0)) return;
    found[1] = HUGE_VAL;
    return;
  }
  unequal_pair_look_up(log(v), 0.0, p, found);
  if (!inside) found[1] = HUGE_VAL;
}

UNEQUAL_PAIR_FUNCTION double unequal_pair_restitution(double speed, double ratio)
{
  double found[2];
  unequal_pair_at(speed, ratio, found);
  return found[0];
}

UNEQUAL_PAIR_FUNCTION double unequal_pair_restitution_error(double speed, double ratio)
{
  double found[2];
  unequal_pair_at(speed, ratio, found);
  return found[1];
}

#undef UNEQUAL_PAIR_FUNCTION
#undef UNEQUAL_PAIR_INDEX

#endif
