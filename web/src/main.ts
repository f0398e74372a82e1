// The page: inputs on one side, what is computed from them on the other.
import './drawing/pictures.css';
import { createAngleChart } from './charts/angle_chart';
import { createCurveChart } from './charts/curve_chart';
import { createModeBars } from './charts/mode_bars';
import { modelPoints } from './charts/model_picture';
import { createTimeCharts } from './charts/time_charts';
import { createCore } from './core/client';
import type { Core, Encounter, Motion, Restitution } from './core/protocol';
import { find, messageOf } from './drawing/dom';
import { loadPlot } from './drawing/library';
import { say } from './drawing/words';
import { fromAddress } from './inputs/address';
import { refusal } from './inputs/check';
import { equal, meetingOf, meetsBody } from './inputs/document';
import { type Inputs, equalInputs, motionOf } from './inputs/inputs';
import { onAxisOf, usualSeries } from './inputs/units';
import { createAddressBar } from './page/address_bar';
import { createAngles, createCurves, createPredictions } from './page/background';
import { createControls } from './page/controls';
import { showKept } from './page/kept_view';
import { createPredictionView, isPredicted, spokenOf } from './page/prediction_view';
import { createResults } from './page/results';
import { createSession, settle } from './page/session';
import { createShare } from './page/share';
import { createSound } from './page/sound';
import { createWorksheet } from './page/worksheet';
import { createHops } from './scene/hop_film';
import { createScene } from './scene/scene';

const results = createResults();
let inputs = fromAddress(location.search).inputs;
const loading = createCore(inputs.encounter, () => void loadPlot(), () => {
  // What was taken for granted is known now.
  if (ready && meetingOf(inputs.encounter).kind === 'hollow-sphere') controls.check();
});
/** The core, which can be asked before it is there. */
const core = (async (...asked: Parameters<Core>) => (await loading)(...asked)) as Core;
let [ready, touched] = [false, false];
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
const worksheet = createWorksheet();
const predictions = createPredictions(core, {
  one(encounter, prediction) {
    runFilm();
    predictionView.show(encounter, prediction);
    if (inputs.view === 'ball') worksheet.show(inputs, prediction);
    if (inputs.view === 'ball' && prediction.influences.length > 0) results.speak(spokenOf(prediction));
    markFirstValue();
  },
  curve: showCurves,
  failed(line) {
    runFilm();
    predictionView.fail(line);
  },
});
/** Asks for what a real ball shows besides its prediction, once. */
let runFilm = (): void => undefined;
const angles = createAngles(core, angleChart.setPoints, (line) => results.say(line));
const share = createShare(core, curves.of, pictures);
const writeAddress = createAddressBar((next, problem) => {
  controls.show(next);
  results.say(problem);
  compute(next);
});
const controls = createControls(inputs, {
  changed(next, settled) {
    touched = true;
    take({ ...next, kept: inputs.kept }, settled);
  },
  wrong() {
    touched = true;
    results.stale('wrong');
    predictionView.stale();
    worksheet.wait();
  },
});

const run = createSession(core, {
  began,
  first(encounter, result, motion) {
    results.show(encounter, result, 'first', false);
    showPoint(result, motion);
    if (inputs.view !== 'ball') markFirstValue();
  },
  final(encounter, result, motion) {
    results.show(encounter, result, 'final', inputs.view !== 'ball' || motion.friction !== 0);
    showPoint(result, motion);
    if (motion.friction !== 0) void angles(encounter, motion);
    if (hasHops(encounter, motion)) void hops(encounter, motion);
    if (inputs.view === 'ball') return;
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
  if (!ready) return;
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
  worksheet.wait();
  const isBall = next.view === 'ball';
  predictionView.begin({ ...next, friction: isBall ? 0 : motion.friction });
  if (!isBall) {
    run(next.encounter, motion);
    return;
  }
  began();
  runFilm = () => {
    runFilm = () => undefined;
    run(next.encounter, motion);
  };
  void predictions.want(next.encounter, next.speed, [], before ? settle : 0);
}

/** What is shown belongs to earlier inputs. */
function began(): void {
  results.stale('computing');
  document.body.dataset.impact = 'old';
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

/** Says in the browser's timeline when the first value was there. */
function markFirstValue(): void {
  if (performance.getEntriesByName('first-value').length === 0) performance.mark('first-value');
}

find('prediction', HTMLElement).hidden = inputs.view !== 'ball';
loading.then(() => {
  ready = true;
  performance.mark('core');
  for (const control of document.querySelectorAll<HTMLInputElement>('[data-waits]')) control.disabled = false;
  if (touched) {
    controls.check();
    return;
  }
  const start = fromAddress(location.search);
  controls.show(start.inputs);
  results.say(start.problem);
  compute(start.inputs);
}, (error: unknown) => results.say(say('page.no_core', { why: messageOf(error) })));
