/* Coefficient of restitution of elastic bodies against their speed of approach.
 *
 *   stoss_restitution(v)        at the speed of approach v, in m/s; its sign does not count
 *   stoss_restitution_error(v)  its error, interpolation included: at most 0.00068
 *
 * Speeds go from STOSS_SLOWEST to STOSS_FASTEST. Beyond, the coefficient is that at the nearer end,
 * and its error HUGE_VAL. NaN gives NaN.
 *
 * A cubic in ln v, monotone where the values are, between values computed at 47 speeds.
 *
 * stoss 2.0.0: table
 * command: stoss table --body sphere --poisson 0.45 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format c -o restitution.h
 * first: {"kind":"sphere","radius":0.1,"material":{"young":1000000.0,"poisson":0.45,"density":1000.0}}
 * against: wall
 * speed[m/s]: 0.01:10
 * error: 0.001
 * beyond: clamp
 */
#ifndef STOSS_RESTITUTION_TABLE
#define STOSS_RESTITUTION_TABLE

#include <math.h>

#if defined(__GNUC__)
#define STOSS_FUNCTION static __inline__ __attribute__((unused))
#elif defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L)
#define STOSS_FUNCTION static inline
#else
#define STOSS_FUNCTION static
#endif
#ifdef __cplusplus
#define STOSS_INDEX(x) static_cast<int>(x)
#else
#define STOSS_INDEX(x) ((int)(x))
#endif

#define STOSS_SLOWEST 0.01
#define STOSS_FASTEST 10.0

/* ln(speed) */
static const double stoss_restitution_speeds[47] = {
  -4.605170185988091, -4.413288094905255, -4.221406003822418, -4.029523912739581,
  -3.837641821656743, -3.6457597305739053, -3.4538776394910684, -3.2619955484082315,
  -3.0701134573253945, -2.8782313662425576, -2.6863492751597207, -2.4944671840768837,
  -2.302585092994046, -2.110703001911208, -1.9188209108283711, -1.726938819745534,
  -1.5350567286626973, -1.3431746375798603, -1.1512925464970234, -0.9594104554141863,
  -0.7675283643313485, -0.5756462732485108, -0.3837641821656737, -0.2878231366242552,
  -0.1918820910828369, -0.09594104554141845, 2.2204460492503128e-16, 0.09594104554141858,
  0.19188209108283708, 0.2878231366242555, 0.38376418216567393, 0.4797052277070925,
  0.5756462732485113, 0.6715873187899304, 0.7675283643313489, 0.8634694098727672,
  0.9594104554141862, 1.055351500955605, 1.1512925464970234, 1.3431746375798606, 1.5350567286626975,
  1.7269388197455344, 1.9188209108283711, 2.01476195636979, 2.1107030019112085, 2.206644047452627,
  2.302585092994046
};
/* interval in which each of equal parts of it begins */
static const int stoss_restitution_speeds_first[48] = {
  0, 0, 1, 2, 3, 3, 4, 5, 6, 7, 7, 8, 9, 10, 10, 11, 12, 13, 14, 14, 15, 16, 17, 17, 18, 19, 20, 21,
  21, 23, 24, 26, 28, 29, 31, 32, 34, 35, 37, 38, 39, 40, 40, 41, 42, 44, 45, 45
};
/* value at each crossing, and its derivatives along the axes */
static const double stoss_restitution_nodes[94] = {
  0.999986581027123, -0.0001926493807486882, 0.9999496150610991, -0.00023930015851810429,
  0.9998890257037438, 0.0, 0.9998947349584675, 3.811719352090793e-05, 0.9999049085486547,
  8.258123557051568e-05, 0.9999407223277252, 0.0, 0.9999259674768557, -0.00014144409870951914,
  0.9997569356634088, -0.0008393720676598896, 0.9996031285618746, 0.0, 0.9996551856257323,
  0.0004124120532229504, 0.9998201002906307, 0.00040452280888146754, 0.9998708550485346, 0.0,
  0.9996824246126524, -0.0012959542305312297, 0.9993168976317102, -0.0019714524116055073,
  0.9989249287854939, -0.0015829118729275143, 0.9986770063532099, -0.00016263717948398552,
  0.9986603547653425, 0.0, 0.9988102298281634, 0.0007727902569069169, 0.998956957387123, 0.0,
  0.9989194801920492, 0.0, 0.9992064304525005, 0.0, 0.998213076330185, -0.007398256000969425,
  0.9957265306294596, -0.014621907264223506, 0.9941631695254196, -0.01612708996790011,
  0.9926317022017169, -0.014748324485826652, 0.9913167593196583, -0.011634970572138881,
  0.9903470058575957, -0.0071072355234879266, 0.9898212148553929, -0.0006804344663262777,
  0.9897864136179192, 0.0, 0.9900994041783949, 0.003930116007170411, 0.9905735133202097,
  0.00529487403523119, 0.9911206125976199, 0.005593713859592802, 0.9916472372586683,
  0.004654372488878518, 0.9920348427734099, 0.0014059283390004487, 0.9921164929748473, 0.0,
  0.9917040228862828, -0.006133812724363258, 0.9906774790476489, -0.013258815830383623,
  0.989005530728063, -0.020319495769352814, 0.9866680626178638, -0.02830809714830319,
  0.9798580550101083, -0.04193255840924889, 0.9700276007522607, -0.058280004136903894,
  0.9570607893410099, -0.0748281266398826, 0.9409767621530419, -0.09048956039561372,
  0.9317051385267686, -0.10042664321502269, 0.9216770366907416, -0.10822120332611831,
  0.9109134077686423, -0.11537352048148806, 0.8995210845828094, -0.11874295429597599
};
/* of each cell */
static const double stoss_restitution_errors[46] = {
  4.8828334606593234e-05, 4.90060839481622e-05, 4.90060839481622e-05, 4.8995023791392556e-05,
  4.725005452683764e-05, 4.725005452683721e-05, 0.00011407610535673359, 0.00011466506895435644,
  0.000182741951656296, 0.00018285823488405827, 0.00018325759155070408, 0.00018383467945969694,
  0.00018444522261931167, 0.00018514530095698064, 0.0001382875398194924, 0.00013938214140193385,
  0.0004012520425884348, 0.0004177195925981329, 0.0004626466863830019, 0.0004644158656584006,
  0.0004740251015853937, 0.0004740251015853896, 0.00046536064812537846, 0.00046903256664289204,
  0.00030240970263973975, 0.0003187016147893715, 0.000330231917838518, 0.000330231917838518,
  0.00033174503389048974, 0.0003422425298855154, 0.00023192710805659507, 0.00025609895341379644,
  0.0002632909008678846, 0.00028338871810050547, 0.0003063290370443367, 0.0003318267753042181,
  0.00043600265929924476, 0.00047213660065041857, 0.0006102069039424865, 0.0006102069039424865,
  0.0005594777261844692, 0.0006420583189242913, 0.0006717752259634158, 0.0006406626453774912,
  0.0006790993989218004, 0.0006790993989218015
};

/* The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
 * of values a, b and slopes a', b' at its ends. */
STOSS_FUNCTION int stoss_weigh(const double *x, const int *first, int last, double bins, double at, double *w)
{
  double h, t, u;
  int k;
  k = STOSS_INDEX((at - x[0]) * bins);
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

STOSS_FUNCTION double stoss_sum_1(const double *a, int next, const double *w)
{
  const double *b = a + next;
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}

STOSS_FUNCTION void stoss_look_up(double x, double z, double p, double *found)
{
  double w[1][3];
  int k[1];
  k[0] = stoss_weigh(stoss_restitution_speeds, stoss_restitution_speeds_first, 46, 6.659182055849862, x, w[0]);
  found[0] = stoss_sum_1(stoss_restitution_nodes + (k[0] * 2), 2, w[0]);
  found[1] = stoss_restitution_errors[k[0] * 1];
  (void)z;
  (void)p;
}

/* Restitution and its error; what is not a number where the table says nothing. */
STOSS_FUNCTION void stoss_at(double speed, double *found)
{
  double v = fabs(speed), p = 0.0;
  const int inside = v >= STOSS_SLOWEST && v <= STOSS_FASTEST;
  if (!inside) {
    found[0] = found[1] = HUGE_VAL - HUGE_VAL;
    if (!(v >= 0.0)) return;
    found[1] = HUGE_VAL;
    if (v < STOSS_SLOWEST) v = STOSS_SLOWEST;
    if (v > STOSS_FASTEST) v = STOSS_FASTEST;
  }
  stoss_look_up(log(v), 0.0, p, found);
  if (!inside) found[1] = HUGE_VAL;
}

STOSS_FUNCTION double stoss_restitution(double speed)
{
  double found[2];
  stoss_at(speed, found);
  return found[0];
}

STOSS_FUNCTION double stoss_restitution_error(double speed)
{
  double found[2];
  stoss_at(speed, found);
  return found[1];
}

#undef STOSS_FUNCTION
#undef STOSS_INDEX

#endif
