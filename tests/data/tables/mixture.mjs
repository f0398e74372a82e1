// Collision rule of two round elastic bodies with friction: speed v of approach along the normal, sliding s of the
// first body's point of contact over the second's, Coulomb's friction, ratio of the second radius to the first.
//
//   mixture_rule_restitution(v, s, friction, ratio)  of the normal velocity, error at most 0.0014
//   mixture_rule_sliding(v, s, friction, ratio)      s afterwards
//   mixture_rule_collide_2d(a, b, normal, friction), _3d  changes velocities and spins, with the normal from a to b,
//                                              of any length but 0. 1: done. 0: they do not approach, and -1: the
//                                              normal has no direction, an argument is not finite, negative, or
//                                              none of the table (friction, ratio); then nothing changes
//
// Velocities are in m/s, spins times radii too. Errors, interpolation included, are those of
// mixture_rule_restitution_error and mixture_rule_sliding_error, the latter over |v_t| + |spin R| of both + friction v: at
// most 0.0017.
//
// The friction must be MIXTURE_RULE_FRICTION; with another one values are not numbers.
// Ratios go from MIXTURE_RULE_SMALLEST to MIXTURE_RULE_GREATEST; the inverse is the same pair.
// Speeds go from MIXTURE_RULE_SLOWEST to MIXTURE_RULE_FASTEST. Beyond, values are those of the nearer end, errors Infinity.
//
// Where s = 0 there is no friction. |s afterwards| <= |s| and restitution <= 1: no collision gains energy.
//
// stoss
//
// as given

export const MIXTURE_RULE_SLOWEST = 51.7219;
export const MIXTURE_RULE_FASTEST = 1034.438;
export const MIXTURE_RULE_SMALLEST = 1.0;
export const MIXTURE_RULE_GREATEST = 3.0;
export const MIXTURE_RULE_FRICTION = 0.3;

// ln(speed)
const mixture_rule_restitution_speeds = new Float64Array([
  3.9458812895011315, 4.639028470061077, 5.555319201935232, 6.941613563055123
]);
// interval in which each of equal parts of it begins
const mixture_rule_restitution_speeds_first = new Int32Array([
  0, 1, 2, 2, 2
]);
// (ratio - 1)/(ratio + 1)
const mixture_rule_restitution_ratios = new Float64Array([
  0.0, 0.2, 0.5
]);
// interval in which each of equal parts of it begins
const mixture_rule_restitution_ratios_first = new Int32Array([
  0, 1, 1, 1
]);
// ln(speed)
const mixture_rule_sliding_speeds = new Float64Array([
  3.9458812895011315, 5.0444935781692415, 6.941613563055123
]);
// interval in which each of equal parts of it begins
const mixture_rule_sliding_speeds_first = new Int32Array([
  0, 1, 1, 1
]);
// z
const mixture_rule_sliding_slips = new Float64Array([
  -1.0, -0.5, 0.0, 0.5, 0.75, 0.8, 0.9, 1.0
]);
// interval in which each of equal parts of it begins
const mixture_rule_sliding_slips_first = new Int32Array([
  0, 0, 1, 1, 2, 2, 3, 6, 6
]);
// value at each crossing, and its derivatives along the axes
const mixture_rule_restitution_nodes = new Float64Array([
  0.945, -0.007213475204444827, 0.0, 0.0, 0.9433333333333334, -0.007213475204444827,
  -0.020555555555555403, 0.0, 0.9316666666666666, -0.007213475204444827, -0.057222222222222695, 0.0,
  0.94, -0.009837716959933586, 0.0, 0.0, 0.9383333333333334, -0.009837716959933586,
  -0.020555555555555403, 0.0, 0.9266666666666666, -0.009837716959933586, -0.057222222222222695, 0.0,
  0.9249999999999999, -0.02425164813614186, 0.0, 0.0, 0.9233333333333333, -0.02425164813614186,
  -0.020555555555555403, 0.0, 0.9116666666666666, -0.02425164813614186, -0.057222222222222695, 0.0,
  0.85, -0.054101064033336095, 0.0, 0.0, 0.8483333333333334, -0.054101064033336095,
  -0.020555555555555403, 0.0, 0.8366666666666667, -0.054101064033336095, -0.057222222222222695, 0.0
]);
// of each cell
const mixture_rule_restitution_errors = new Float64Array([
  0.00135, 0.00135, 0.00135, 0.00135, 0.00135, 0.00135
]);
// value at each crossing, and its derivatives along the axes
const mixture_rule_sliding_nodes = new Float64Array([
  0.0, 0.0, -0.2286072469804248, 0.0043324505963729665, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
  -0.22844064972927947, 0.0043324505963729925, 0.0, 0.0, 0.0020546994307926634,
  1.1160054362117458e-16, 0.0, 0.0, -0.227274468971262, 0.004332450596373018, 0.0, 0.0,
  0.005719838955990477, 5.608939238991677e-17, -0.0964493960849646, 0.0017628539790982012,
  -0.15719033735943358, 0.002718965320019838, 0.0, 0.0, 0.0, 0.0, -0.09646327918922672,
  0.001762853979098214, -0.1574124670276274, 0.0027189653200198637, -0.00017122495256607917,
  3.838075690598686e-17, -0.0027395992410569805, 4.26452854510965e-17, -0.09656046091906151,
  0.001762853979098214, -0.15896737470498404, 0.002718965320019838, -0.00047665324633253126,
  -3.838075690598686e-17, -0.007626451941320602, -2.1322642725548255e-16, -0.15719033735943358,
  0.002718965320019838, 0.006048313202832084, -0.0009690010259301514, 0.0, 0.0, 0.0, 0.0,
  -0.1574124670276274, 0.0027189653200198637, 0.004937664861863006, -0.0009690010259301388,
  -0.0027395992410569805, 4.26452854510965e-17, -0.01369799620528489, 3.7730235602495554e-17,
  -0.15896737470498404, 0.002718965320019838, -0.002836873524920236, -0.0009690010259301388,
  -0.007626451941320602, -2.1322642725548255e-16, -0.03813225970660339, -3.7730235602495554e-17,
  -0.09040108288213253, 0.0007938529531680496, 0.3822623906705541, -0.009468610963861718, 0.0, 0.0,
  0.0, 0.0, -0.0915256143273637, 0.0007938529531680749, 0.37910398445092347, -0.009468610963861784,
  -0.013869221157850905, 7.578573185673676e-17, -0.03895367670877846, -1.7694179454963432e-16,
  -0.09939733444398174, 0.0007938529531680749, 0.3569951409135086, -0.009468610963861769,
  -0.03860891295293608, -7.578573185673676e-17, -0.10843861354065408, 2.8102520310824275e-16,
  0.036250000000000004, -0.0022755980665671474, 3.296934055254755, 0.005539026208732676, 0.0, 0.0,
  0.0, 0.0, 0.03416666666666668, -0.0022755980665671474, 3.303239298440464, 0.005539026208734345,
  -0.025694444444444353, 0.0, 0.07776466595708403, 5.006411951669065e-15, 0.019583333333333397,
  -0.0022755980665671474, 3.3473760007404314, 0.005539026208734345, -0.07152777777777752, 0.0,
  0.21648001604269912, -5.006411951669065e-15, 0.2290000000000002, -0.0018204784532537784, 3.855,
  0.00910239226626771, 0.0, 0.0, 0.0, 0.0, 0.2273333333333335, -0.0018204784532536774,
  3.863333333333333, 0.009102392266269058, -0.02055555555555559, 3.0314292742694704e-16,
  0.10277777777777669, 3.594925283382603e-15, 0.2156666666666669, -0.0018204784532536774,
  3.9216666666666664, 0.009102392266268721, -0.05722222222222177, -3.0314292742694704e-16,
  0.2861111111111138, -5.838500978979274e-15, 0.6145, -0.0009102392266269397, 3.8549999999999995,
  0.009102392266268893, 0.0, 0.0, 0.0, 0.0, 0.6136666666666667, -0.0009102392266268387,
  3.8633333333333333, 0.009102392266268388, -0.010277777777777719, 1.68412737459415e-16,
  0.10277777777777874, -1.5121006298931168e-15, 0.6078333333333334, -0.0009102392266269397,
  3.9216666666666664, 0.00910239226626839, -0.028611111111110588, -8.420636872970751e-16,
  0.28611111111110876, 1.5236654530662954e-15, 1.0, 0.0, 3.8550000000000013, 0.009102392266269906,
  0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 3.863333333333334, 0.009102392266268388, 0.0, 0.0,
  0.10277777777777491, -1.8590453250884772e-15, 1.0, 0.0, 3.9216666666666664, 0.00910239226627041,
  0.0, 0.0, 0.2861111111111067, 1.533206432184168e-14, 0.0, 0.0, -0.223847563515202,
  0.0068015706357273335, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.22368096626405662, 0.006801570635727371,
  0.0, 0.0, 0.0020546994307927835, 1.5699247457590104e-16, 0.0, 0.0, -0.22251478550603912,
  0.006801570635727405, 0.0, 0.0, 0.005719838955990542, 6.852157730108388e-17, -0.09451270304039984,
  0.0027675274287829923, -0.15420324864639737, 0.004268539079404636, 0.0, 0.0, 0.0, 0.0,
  -0.09452658614466194, 0.00276752742878301, -0.15442537831459116, 0.0042685390794046695,
  -0.00017122495256603754, 5.334274688628682e-17, -0.0027395992410569336, 5.637851296924623e-17,
  -0.09462376787449674, 0.00276752742878301, -0.15598028599194783, 0.004268539079404636,
  -0.0004766532463325729, -5.334274688628682e-17, -0.007626451941320833, -2.8189256484623115e-16,
  -0.15420324864639737, 0.004268539079404636, 0.0049837567680132006, -0.001521247335047225, 0.0,
  0.0, 0.0, 0.0, -0.15442537831459116, 0.0042685390794046695, 0.003873108427044164,
  -0.0015212473350472095, -0.0027395992410569336, 5.637851296924623e-17, -0.013697996205284784,
  4.683753385137379e-17, -0.15598028599194783, 0.004268539079404636, -0.0039014299597390917,
  -0.0015212473350472095, -0.007626451941320833, -2.8189256484623115e-16, -0.03813225970660359,
  -4.683753385137379e-17, -0.08952894627238664, 0.0012462800937357672, 0.371860058309038,
  -0.014864895712104184, 0.0, 0.0, 0.0, 0.0, -0.09065347771761778, 0.0012462800937358012,
  0.3687016520894073, -0.014864895712104274, -0.013869221157850822, 1.0213184464813452e-16,
  -0.038953676708778556, -2.405483220021173e-16, -0.09852519783423583, 0.0012462800937358012,
  0.3465928085519925, -0.014864895712104252, -0.03860891295293616, -1.0213184464813452e-16,
  -0.10843861354065362, 3.908910232534405e-16, 0.03374999999999995, -0.0035724910518860845,
  3.3030192975149233, 0.008695789409204378, 0.0, 0.0, 0.0, 0.0, 0.03166666666666662,
  -0.0035724910518860845, 3.309324540700634, 0.00869578940920657, -0.025694444444444353, 0.0,
  0.07776466595708995, 6.5780714209040525e-15, 0.01708333333333334, -0.0035724910518860845,
  3.353461243000602, 0.00869578940920657, -0.07152777777777752, 0.0, 0.21648001604269615,
  -6.5780714209040525e-15, 0.2270000000000001, -0.002857992841508947, 3.8649999999999993,
  0.01428996420754318, 0.0, 0.0, 0.0, 0.0, 0.2253333333333335, -0.0028579928415088138,
  3.8733333333333335, 0.014289964207544964, -0.020555555555555258, 3.9942008034365983e-16,
  0.10277777777778008, 4.751407600700475e-15, 0.2136666666666669, -0.0028579928415088138,
  3.9316666666666666, 0.014289964207544512, -0.057222222222222105, -3.9942008034365983e-16,
  0.28611111111110743, -7.769826448900119e-15, 0.6134999999999999, -0.0014289964207545413, 3.865,
  0.014289964207544737, 0.0, 0.0, 0.0, 0.0, 0.6126666666666667, -0.0014289964207544056,
  3.873333333333333, 0.014289964207544071, -0.010277777777777535, 2.2623685332530853e-16,
  0.10277777777777669, -1.9960884796906458e-15, 0.6068333333333333, -0.0014289964207545413,
  3.9316666666666666, 0.014289964207544073, -0.028611111111111514, -1.131184266626543e-15,
  0.2861111111111138, 2.0076533028638246e-15, 1.0, 0.0, 3.865000000000003, 0.014289964207546097,
  0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 3.873333333333335, 0.014289964207544047, 0.0, 0.0,
  0.10277777777777403, -2.53153979260882e-15, 1.0, 0.0, 3.9316666666666684, 0.014289964207546762,
  0.0, 0.0, 0.2861111111111165, 2.063048805863351e-14, 0.0, 0.0, -0.18339025406080806,
  0.021325646125027554, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.18322365680966265, 0.021325646125027572,
  0.0, 0.0, 0.00205469943079283, 2.891205793294678e-17, 0.0, 0.0, -0.18205747605164518,
  0.021325646125027554, 0.0, 0.0, 0.005719838955990311, -1.4456028966473394e-16,
  -0.07805081216159936, 0.008677306132427214, -0.12881299458558937, 0.0133835784046813, 0.0, 0.0,
  0.0, 0.0, -0.07806469526586146, 0.008677306132427214, -0.1290351242537832, 0.013383578404681285,
  -0.00017122495256603754, 0.0, -0.0027395992410569805, -2.6020852139652106e-17,
  -0.07816187699569625, 0.008677306132427214, -0.13059003193113983, 0.0133835784046813,
  -0.0004766532463325729, 0.0, -0.007626451941320602, 1.3010426069826053e-16, -0.12881299458558937,
  0.0133835784046813, -0.004064972927946789, -0.004769719241824498, 0.0, 0.0, 0.0, 0.0,
  -0.1290351242537832, 0.013383578404681285, -0.005175621268915825, -0.004769719241824497,
  -0.0027395992410569805, -2.6020852139652106e-17, -0.013697996205284784, 2.8912057932946775e-18,
  -0.13059003193113983, 0.0133835784046813, -0.012950159655699081, -0.004769719241824498,
  -0.007626451941320602, 1.3010426069826053e-16, -0.03813225970660359, -1.4456028966473393e-17,
  -0.08211578508954614, 0.003907586890602717, 0.28344023323615175, -0.04660739741150588, 0.0, 0.0,
  0.0, 0.0, -0.08324031653477729, 0.003907586890602717, 0.28028182701652105, -0.046607397411505866,
  -0.013869221157850822, 0.0, -0.038953676708778695, 2.312964634635742e-17, -0.09111203665139533,
  0.003907586890602717, 0.2581729834791061, -0.04660739741150588, -0.03860891295293616, 0.0,
  -0.1084386135406542, -1.1564823173178715e-16, 0.012499999999999956, -0.01120118926019234,
  3.3547438567263645, 0.027264780100111838, 0.0, 0.0, 0.0, 0.0, 0.01041666666666663,
  -0.01120118926019234, 3.3610490999120732, 0.027264780100110853, -0.025694444444444353, 0.0,
  0.0777646659570827, -2.9559688030644793e-15, -0.004166666666666652, -0.01120118926019234,
  3.4051858022120407, 0.027264780100110853, -0.07152777777777752, 0.0, 0.21648001604270045,
  2.9559688030644793e-15, 0.2100000000000002, -0.008960951408153825, 3.95, 0.04480475704076989, 0.0,
  0.0, 0.0, 0.0, 0.20833333333333348, -0.008960951408153884, 3.9583333333333335, 0.0448047570407693,
  -0.02055555555555559, -1.7694179454963432e-16, 0.10277777777777741, -1.7694179454963432e-15,
  0.19666666666666688, -0.008960951408153884, 4.016666666666667, 0.0448047570407693,
  -0.05722222222222177, 1.7694179454963432e-16, 0.2861111111111101, 1.7694179454963432e-15, 0.605,
  -0.0044804757040769125, 3.95, 0.04480475704076913, 0.0, 0.0, 0.0, 0.0, 0.6041666666666667,
  -0.0044804757040769125, 3.9583333333333335, 0.04480475704076943, -0.010277777777777535, 0.0,
  0.10277777777777741, 8.951173136040325e-16, 0.5983333333333334, -0.0044804757040769125,
  4.016666666666667, 0.04480475704076943, -0.028611111111111514, 0.0, 0.2861111111111101,
  -8.951173136040325e-16, 1.0, 0.0, 3.950000000000002, 0.04480475704076913, 0.0, 0.0, 0.0, 0.0, 1.0,
  0.0, 3.9583333333333335, 0.04480475704076883, 0.0, 0.0, 0.10277777777777447,
  -8.951173136040325e-16, 1.0, 0.0, 4.016666666666668, 0.04480475704076883, 0.0, 0.0,
  0.2861111111111249, 8.951173136040325e-16
]);
// of each cell
const mixture_rule_sliding_errors = new Float64Array([
  0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001,
  0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001,
  0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001,
  0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001,
  0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001,
  0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001,
  0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001, 0.0016625000000000001
]);

// The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
// of values a, b and slopes a', b' at its ends.
function mixture_rule_weigh(x, first, last, bins, at, w) {
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

function mixture_rule_sum_1(a, next, w) {
  const b = a.subarray(next);
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}

function mixture_rule_sum_2(a, next, line, w, y) {
  const b = a.subarray(line);
  const begin = mixture_rule_sum_1(a, next, w), end = mixture_rule_sum_1(b, next, w);
  return begin + y[0] * (end - begin) + y[1] * mixture_rule_sum_1(a.subarray(2), next, w) - y[2] * mixture_rule_sum_1(b.subarray(2), next, w);
}

function mixture_rule_sum_3(a, next, line, plane, w, y,
                                    z) {
  const b = a.subarray(plane);
  const begin = mixture_rule_sum_2(a, next, line, w, y), end = mixture_rule_sum_2(b, next, line, w, y);
  return begin + z[0] * (end - begin) + z[1] * mixture_rule_sum_2(a.subarray(4), next, line, w, y) -
         z[2] * mixture_rule_sum_2(b.subarray(4), next, line, w, y);
}

function mixture_rule_look_up(x, z, p, found) {
  const w = [], k = [];
  for (let i = 0; i < 4; ++i) w[i] = [0.0, 0.0, 0.0];
  k[0] = mixture_rule_weigh(mixture_rule_restitution_speeds, mixture_rule_restitution_speeds_first, 3, 1.001424602086002, x, w[0]);
  k[1] = mixture_rule_weigh(mixture_rule_restitution_ratios, mixture_rule_restitution_ratios_first, 2, 4.0, p, w[1]);
  k[2] = mixture_rule_weigh(mixture_rule_sliding_speeds, mixture_rule_sliding_speeds_first, 2, 0.667616401390668, x, w[2]);
  k[3] = mixture_rule_weigh(mixture_rule_sliding_slips, mixture_rule_sliding_slips_first, 7, 3.5, z, w[3]);
  found[0] = mixture_rule_sum_2(mixture_rule_restitution_nodes.subarray((k[0] * 12 + k[1] * 4)), 12, 4, w[0], w[1]);
  found[1] = mixture_rule_restitution_errors[k[0] * 2 + k[1] * 1];
  found[2] = mixture_rule_sum_3(mixture_rule_sliding_nodes.subarray((k[2] * 192 + k[3] * 24 + k[1] * 8)), 192, 24, 8, w[2], w[3], w[1]);
  found[3] = mixture_rule_sliding_errors[k[2] * 14 + k[3] * 2 + k[1] * 1];
  void z;
  void p;
}

// Restitution, its error, sliding after, its error; what is not a number where the table says nothing.
function mixture_rule_at(speed, sliding, friction, ratio, found) {
  const s = Math.abs(sliding), limit = friction * Math.abs(speed), scale = s + limit;
  let v = Math.abs(speed), p = Math.abs((ratio - 1.0) / (ratio + 1.0));
  for (let i = 0; i < 4; ++i) found[i] = NaN;
  if (!(v < Infinity && s < Infinity && !(friction < MIXTURE_RULE_FRICTION) && !(friction > MIXTURE_RULE_FRICTION) && ratio > 0.0 && ratio < Infinity)) return;
  const inside = v >= MIXTURE_RULE_SLOWEST && v <= MIXTURE_RULE_FASTEST && p >= -1e-15 && p <= 0.500000000000001;
  if (!inside) {
    found[1] = found[3] = Infinity;
    if (v < MIXTURE_RULE_SLOWEST) v = MIXTURE_RULE_SLOWEST;
    if (v > MIXTURE_RULE_FASTEST) v = MIXTURE_RULE_FASTEST;
    if (!(p < 0.5)) p = 0.5;
    if (p < 0.0) p = 0.0;
  }
  mixture_rule_look_up(Math.log(v), scale > 0.0 ? (s - limit) / scale : -1.0, p, found);
  if (found[0] < 0.0) found[0] = 0.0;
  if (found[0] > 1.0) found[0] = 1.0;
  let after = found[2] * scale;
  if (after < -s) after = -s;
  if (after > s) after = s;
  found[2] = sliding < 0.0 ? -after : after;
  if (!inside) found[1] = found[3] = Infinity;
}

export function mixture_rule_restitution(speed, sliding, friction, ratio) {
  const found = [];
  mixture_rule_at(speed, sliding, friction, ratio, found);
  return found[0];
}

export function mixture_rule_restitution_error(speed, sliding, friction, ratio) {
  const found = [];
  mixture_rule_at(speed, sliding, friction, ratio, found);
  return found[1];
}

export function mixture_rule_sliding(speed, sliding, friction, ratio) {
  const found = [];
  mixture_rule_at(speed, sliding, friction, ratio, found);
  return found[2];
}

export function mixture_rule_sliding_error(speed, sliding, friction, ratio) {
  const found = [];
  mixture_rule_at(speed, sliding, friction, ratio, found);
  return found[3];
}

// A round body is {inverse_mass, inverse_inertia, radius, velocity, spin}: inverse_mass 0 does not move, inverse_inertia
// 0 does not turn. In the plane velocity is [x, y], and spin, from x to y, a number; in space both are [x, y, z].

// The normal at length 1, from one of any length; undefined if it has no direction.
function mixture_rule_direction(normal, count) {
  const n = [];
  let greatest = 0.0, square = 0.0;
  for (let i = 0; i < count; ++i) {
    if (!(Math.abs(normal[i]) < Infinity)) return undefined;
    if (Math.abs(normal[i]) > greatest) greatest = Math.abs(normal[i]);
  }
  if (!(greatest > 0.0)) return undefined;
  for (let i = 0; i < count; ++i) n[i] = normal[i] / greatest;
  for (let i = 0; i < count; ++i) square += n[i] * n[i];
  for (let i = 0; i < count; ++i) n[i] /= Math.sqrt(square);
  return n;
}

// Whether the numbers of a body are finite, and mass, moment of inertia and radius not negative.
function mixture_rule_is_motion(body, velocity, spin) {
  let nothing = 0.0 * body.inverse_mass + 0.0 * body.inverse_inertia + 0.0 * body.radius;
  for (const each of velocity) nothing += 0.0 * each;
  for (const each of spin) nothing += 0.0 * each;
  return body.inverse_mass >= 0.0 && body.inverse_inertia >= 0.0 && body.radius >= 0.0 && nothing >= 0.0;
}

// The impulse along the normal, and that of friction against sliding s, over s; undefined if refused.
function mixture_rule_impulse(speed, sliding, friction, ratio, mobility, turning) {
  const found = [];
  mixture_rule_at(speed, sliding, friction, ratio, found);
  const slides = Math.abs(sliding) > 0.0;
  const along = slides ? (sliding - found[2]) / ((mobility + turning) * sliding) : 0.0 * found[2];
  return found[1] >= 0.0 ? [((1.0 + found[0]) * speed) / mobility, along] : undefined;
}

export function mixture_rule_collide_2d(a, b, normal, friction) {
  const way = mixture_rule_direction(normal, 2);
  if (!way || ![a, b].every((each) => mixture_rule_is_motion(each, [each.velocity[0], each.velocity[1]], [each.spin]))) return -1;
  const [n, m] = way;
  const x = a.velocity[0] - b.velocity[0], y = a.velocity[1] - b.velocity[1];
  const mobility = a.inverse_mass + b.inverse_mass;
  const arm_a = a.radius * a.inverse_inertia, arm_b = b.radius * b.inverse_inertia;
  const speed = x * n + y * m, sliding = y * n - x * m + a.radius * a.spin + b.radius * b.spin;
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  const turning = a.radius * arm_a + b.radius * arm_b;
  const given = mixture_rule_impulse(speed, sliding, friction, b.radius / a.radius, mobility, turning);
  if (!given) return -1;
  const push = given[0], drag = given[1] * sliding;
  const impulse = [push * n - drag * m, push * m + drag * n];
  for (let i = 0; i < 2; ++i) {
    a.velocity[i] -= a.inverse_mass * impulse[i];
    b.velocity[i] += b.inverse_mass * impulse[i];
  }
  a.spin -= arm_a * drag;
  b.spin -= arm_b * drag;
  return 1;
}

export function mixture_rule_collide_3d(a, b, normal, friction) {
  const way = mixture_rule_direction(normal, 3), three = (of) => [of[0], of[1], of[2]];
  if (!way || ![a, b].every((each) => mixture_rule_is_motion(each, three(each.velocity), three(each.spin)))) return -1;
  const [n, m, l] = way;
  const [x, y, z] = [0, 1, 2].map((i) => a.velocity[i] - b.velocity[i]);
  const [p, q, r] = [0, 1, 2].map((i) => a.radius * a.spin[i] + b.radius * b.spin[i]);
  const mobility = a.inverse_mass + b.inverse_mass;
  const arm_a = a.radius * a.inverse_inertia, arm_b = b.radius * b.inverse_inertia;
  const speed = x * n + y * m + z * l;
  const u = x - speed * n + (q * l - r * m), v = y - speed * m + (r * n - p * l), w = z - speed * l + (p * m - q * n);
  if (!(speed > 0.0) || !(mobility > 0.0)) return 0;
  const sliding = Math.sqrt(u * u + v * v + w * w), turning = a.radius * arm_a + b.radius * arm_b;
  const given = mixture_rule_impulse(speed, sliding, friction, b.radius / a.radius, mobility, turning);
  if (!given) return -1;
  const [push, drag] = given;
  const impulse = [push * n + drag * u, push * m + drag * v, push * l + drag * w];
  const moment = [drag * (m * w - l * v), drag * (l * u - n * w), drag * (n * v - m * u)];
  for (let i = 0; i < 3; ++i) {
    a.velocity[i] -= a.inverse_mass * impulse[i];
    b.velocity[i] += b.inverse_mass * impulse[i];
    a.spin[i] -= arm_a * moment[i];
    b.spin[i] -= arm_b * moment[i];
  }
  return 1;
}
