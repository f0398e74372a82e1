// Coefficient of restitution of elastic bodies against their speed of approach.
//
//   stoss_restitution(v)        at the speed of approach v, in m/s; its sign does not count
//   stoss_restitution_error(v)  its error, interpolation included: at most 0.00073
//
// Speeds go from STOSS_SLOWEST to STOSS_FASTEST. Beyond, the coefficient is that at the nearer end,
// and its error Infinity. NaN gives NaN.
//
// A cubic in ln v, monotone where the values are, between values computed at 37 speeds.
//
// stoss 2.0.0: table
// command: stoss table --body disk --poisson 0.4 --young 1e6 --density 1000 --radius 0.1 --speed 0.01:10 --format js -o restitution.mjs
// first: {"kind":"disk","radius":0.1,"material":{"young":1000000.0,"poisson":0.4,"density":1000.0},"plane":"stress"}
// against: wall
// speed[m/s]: 0.01:10
// error: 0.001
// beyond: clamp

export const STOSS_SLOWEST = 0.01;
export const STOSS_FASTEST = 10.0;

// ln(speed)
const stoss_restitution_speeds = new Float64Array([
  -4.605170185988091, -4.413288094905255, -4.221406003822418, -4.029523912739581,
  -3.837641821656743, -3.6457597305739053, -3.4538776394910684, -3.2619955484082315,
  -3.0701134573253945, -2.8782313662425576, -2.6863492751597207, -2.4944671840768837,
  -2.302585092994046, -2.110703001911208, -1.9188209108283711, -1.726938819745534,
  -1.5350567286626973, -1.3431746375798603, -1.1512925464970234, -0.9594104554141863,
  -0.7675283643313485, -0.5756462732485108, -0.3837641821656737, -0.1918820910828369,
  2.2204460492503128e-16, 0.19188209108283708, 0.38376418216567393, 0.5756462732485113,
  0.7675283643313489, 0.9594104554141862, 1.1512925464970234, 1.3431746375798606,
  1.5350567286626975, 1.7269388197455344, 1.9188209108283711, 2.1107030019112085, 2.302585092994046
]);
// interval in which each of equal parts of it begins
const stoss_restitution_speeds_first = new Int32Array([
  0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25,
  26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 35
]);
// value at each crossing, and its derivatives along the axes
const stoss_restitution_nodes = new Float64Array([
  0.9918415705552969, -0.006899797582483425, 0.9905176229671216, -0.00716819292458925,
  0.9890865060796104, -0.00758717423444132, 0.9876050678301064, -0.007803505223721039,
  0.9860914546335143, -0.007826201132400451, 0.9846014663309403, -0.007393015421646953,
  0.9832477498950488, -0.006504728802432168, 0.9820899082530753, -0.005637517160967959,
  0.981074885478873, -0.004680061612281615, 0.9802696821258595, -0.0030898048912881295,
  0.9798005183218104, -0.0012287364218008389, 0.9796430702718415, 0.0, 0.9797814831042468,
  0.0010675511027124262, 0.9801753751498622, 0.0024604227807793525, 0.9807644682327955,
  0.0036252830717688174, 0.981613667531528, 0.004953488603464659, 0.9826928732675536,
  0.005604921716058683, 0.9837646613098818, 0.005103358722063746, 0.9846660710818783,
  0.004042336696169881, 0.9853467587897681, 0.0024547592582573738, 0.9857068644678978, 0.0,
  0.9855998859901258, -0.0009616968075519021, 0.9849289840666579, -0.0046527456642843105,
  0.9835950572583558, -0.008569948055146276, 0.9814517483683467, -0.01328527473736234,
  0.97830699160038, -0.01914674697152297, 0.9738898035547955, -0.026262710382998843,
  0.9680243122132173, -0.033858480623153074, 0.9607438253566648, -0.04179399495811726,
  0.9518182869829066, -0.051908390237544205, 0.9405518616171217, -0.0654023525513999,
  0.9263893794614849, -0.08008273251041403, 0.909595260443049, -0.09333579257437426,
  0.8904117592923613, -0.10569093629662057, 0.8689018678987783, -0.11644079349242306,
  0.8456588341659992, -0.12429498891065069, 0.8211693545123193, -0.1276277505393015
]);
// of each cell
const stoss_restitution_errors = new Float64Array([
  0.00010859236856006758, 0.00011471085777073854, 0.00011471085777073854, 0.00011136849362286815,
  0.00010192856054935202, 0.00010313812196227745, 0.00010498464123905908, 0.00011017673658954555,
  0.00034932563075416455, 0.00034932563075416455, 0.0003270466106961048, 0.0003332485340318367,
  0.0003332485340318367, 0.0003356930341073804, 0.00018306135665585702, 0.00018807912921242197,
  0.00013093825201192355, 0.0001366993060511354, 0.00032158491542234375, 0.00032908746611377924,
  0.00033752364893530117, 0.0003481563951823949, 0.0003612288577748671, 0.0003761922720836784,
  0.0003136256201495857, 0.0003343568375194691, 0.00042897015748407947, 0.00042976166448871044,
  0.0005402211102801713, 0.000573685131610319, 0.000573685131610319, 0.0006450666904065761,
  0.000729978057857389, 0.0006383634124283737, 0.0005682131522379215, 0.0005221485125245181
]);

// The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
// of values a, b and slopes a', b' at its ends.
function stoss_weigh(x, first, last, bins, at, w) {
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

function stoss_sum_1(a, next, w) {
  const b = a.subarray(next);
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}

function stoss_look_up(x, z, p, found) {
  const w = [], k = [];
  for (let i = 0; i < 1; ++i) w[i] = [0.0, 0.0, 0.0];
  k[0] = stoss_weigh(stoss_restitution_speeds, stoss_restitution_speeds_first, 36, 5.211533782839022, x, w[0]);
  found[0] = stoss_sum_1(stoss_restitution_nodes.subarray((k[0] * 2)), 2, w[0]);
  found[1] = stoss_restitution_errors[k[0] * 1];
  void z;
  void p;
}

// Restitution and its error; what is not a number where the table says nothing.
function stoss_at(speed, found) {
  let v = Math.abs(speed), p = 0.0;
  const inside = v >= STOSS_SLOWEST && v <= STOSS_FASTEST;
  if (!inside) {
    found[0] = found[1] = NaN;
    if (!(v >= 0.0)) return;
    found[1] = Infinity;
    if (v < STOSS_SLOWEST) v = STOSS_SLOWEST;
    if (v > STOSS_FASTEST) v = STOSS_FASTEST;
  }
  stoss_look_up(Math.log(v), 0.0, p, found);
  if (!inside) found[1] = Infinity;
}

export function stoss_restitution(speed) {
  const found = [];
  stoss_at(speed, found);
  return found[0];
}

export function stoss_restitution_error(speed) {
  const found = [];
  stoss_at(speed, found);
  return found[1];
}
