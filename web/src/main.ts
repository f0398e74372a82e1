// The page: inputs on one side, what is computed from them on the other.
import 'katex/dist/katex.min.css';
import './drawing/pictures.css';
import { createAngleChart } from './charts/angle_chart';
import { createCurveChart } from './charts/curve_chart';
import { createModeBars } from './charts/mode_bars';
import { modelPoints } from './charts/model_picture';
import { createTimeCharts } from './charts/time_charts';
import { createCore } from './core/client';
import type { Encounter, Motion, Restitution } from './core/protocol';
import { find, messageOf } from './drawing/dom';
import { fromAddress } from './inputs/address';
import { refusal } from './inputs/check';
import { equal, meetingOf, meetsBody } from './inputs/document';
import { type Inputs, equalInputs, motionOf } from './inputs/inputs';
import { onAxisOf, usualSeries } from './inputs/units';
import { createAddressBar } from './page/address_bar';
import { createAngles, createCurves, createPredictions } from './page/background';
import { createControls } from './page/controls';
import { showKept } from './page/kept_view';
import { createPredictionView, isPredicted } from './page/prediction_view';
import { createResults } from './page/results';
import { createSession } from './page/session';
import { createShare } from './page/share';
import { createSound } from './page/sound';
import { createHops } from './scene/hop_film';
import { createScene } from './scene/scene';

const results = createResults();
const core = await createCore().catch((error: unknown) => {
  results.say(`The core could not be loaded: ${messageOf(error)}`);
  throw error;
});
const start = fromAddress(location.search);
let inputs = start.inputs;
/** What is computed, or under way; undefined after a failure. */
let computed: Inputs | undefined;

const scene = createScene(find('scene', HTMLElement), core, (time) => timeCharts.setCursor(time));
const timeCharts = createTimeCharts(find('time-charts', HTMLElement), (time) => scene.seek(time));
const curveChart = createCurveChart(find('curve-chart', HTMLElement), (speed) => pick({ speed }));
const angleChart = createAngleChart(find('angle-chart', HTMLElement), (angle) => pick({ angle }));
const hops = createHops(find('hop-scene', HTMLElement), core);
const showSound = createSound(core);
const modeBars = createModeBars(find('mode-bars', HTMLElement), core);

const pictures = {
  curve: curveChart.picture, angle: angleChart.picture, time: timeCharts.picture, modes: modeBars.picture,
  collision: scene.picture,
};
const curves = createCurves(core, showCurves, (line) => results.say(line));
const predictionView = createPredictionView();
const predictions = createPredictions(core,
  { one: predictionView.show, curve: showCurves, failed: predictionView.fail });
const angles = createAngles(core, angleChart.setPoints, (line) => results.say(line));
const share = createShare(core, curves.of, pictures);
const writeAddress = createAddressBar((next, problem) => {
  controls.show(next);
  results.say(problem);
  compute(next);
});
const controls = createControls(inputs, {
  changed: (next, settled) => take({ ...next, kept: inputs.kept }, settled),
  wrong: () => results.stale('wrong'),
});

const run = createSession(core, {
  began() {
    results.stale('computing');
    document.body.dataset.impact = 'old';
  },
  first(encounter, result, motion) {
    results.show(encounter, result, 'first');
    showPoint(result, motion);
  },
  final(encounter, result, motion) {
    results.show(encounter, result, 'final');
    showPoint(result, motion);
    if (motion.friction !== 0) void angles(encounter, motion);
    if (hasHops(encounter, motion)) void hops(encounter, motion);
    curves.want([encounter, ...inputs.kept]);
    if (isPredicted({ encounter, ...motion })) {
      void predictions.want(encounter, motion.speed, curves.of(encounter).planned);
    }
  },
  collision(encounter, speed, cutoff, collision) {
    void scene.show(encounter, speed, cutoff, collision);
    timeCharts.show(collision);
    modeBars.show(encounter, collision);
    showSound(encounter, speed, cutoff, collision);
    document.body.dataset.impact = 'current';
  },
  oblique(encounter, motion, collision) {
    scene.showOblique(encounter, motion, collision);
    timeCharts.show(collision);
    document.body.dataset.impact = 'current';
  },
  failed(line, refused) {
    computed = undefined;
    predictionView.fail('');
    if (refused) results.stale('wrong');
    if (refused && line.startsWith('speed:')) controls.refuse('speed', line);
    else results.say(line);
  },
});

/** New inputs from a chart. */
function pick(change: Partial<Inputs>): void {
  const next = { ...inputs, ...change };
  controls.show(next);
  take(next, true);
}

/** Whether a ball under a table is shown: with gravity, between what does not move. */
function hasHops(encounter: Encounter, { friction }: Motion): boolean {
  return friction !== 0 && meetingOf(encounter).si && !meetsBody(encounter);
}

/** New inputs from the form, the curve or the list of kept curves. */
function take(next: Inputs, settled: boolean): void {
  writeAddress(next, settled);
  results.say('');
  compute(next);
}

/** Compute what inputs ask for, unless it is there. */
function compute(next: Inputs): void {
  const before = computed;
  inputs = next;
  computed = next;
  share(inputs);
  const motion = motionOf(inputs);
  document.body.dataset.rule = motion.friction === 0 ? 'central' : 'oblique';
  find('hops', HTMLElement).hidden = !hasHops(inputs.encounter, motion);
  showKept(inputs, (kept) => take({ ...inputs, kept }, true));
  if (before !== undefined && equalInputs(before, next)) {
    results.stale('');
    if (before.kept !== next.kept) curves.want([next.encounter, ...next.kept]);
    return;
  }
  const same = before !== undefined && equal(before.encounter, next.encounter) && before.friction === next.friction;
  if (!same) showCurves();
  predictions.stop();
  predictionView.begin({ ...next, ...motion });
  run(next.encounter, motion);
}

function showPoint({ quantities, speed }: Restitution, { angle }: Motion): void {
  const { restitution, tangential_restitution: tangential } = quantities;
  if (restitution === undefined) return;
  const along = { restitution: restitution.value, error: restitution.error ?? 0 };
  curveChart.setCurrent({ speed, ...along });
  if (tangential) angleChart.setCurrent({
    angle, ...along, tangential: tangential.value, tangentialError: tangential.error ?? 0, converged: true,
  });
}

function showCurves(): void {
  series.placeholder = usualSeries(inputs.encounter);
  const all = [inputs.encounter, ...inputs.kept.filter((other) => !equal(other, inputs.encounter))];
  curveChart.setCurves(all.map((encounter) => {
    const { points, planned } = curves.of(encounter);
    const place = (speed: number): number => onAxisOf(inputs.encounter, encounter, speed);
    const placed = points.map((point) => ({ ...point, speed: place(point.speed) }));
    return { encounter, points: placed, planned: planned.map(place) };
  }), isPredicted({ ...inputs, ...motionOf(inputs) }) ? modelPoints(predictions.of(inputs.encounter)) : []);
}

const series = find('series', HTMLInputElement);
series.addEventListener('change', () => {
  const problem = find('series-problem', HTMLElement);
  problem.textContent = refusal(() => curves.at(series.value))?.message ?? '';
  problem.hidden = problem.textContent === '';
});

results.say(start.problem);
compute(inputs);
