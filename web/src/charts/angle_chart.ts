// The chart of ε_t and ε against the angle: points fill in, a reader picks an angle.

import { least } from 'd3-array';
import type { AnglePoint } from '../core/protocol';
import { Plot } from '../drawing/library';
import { withError, written } from '../drawing/numbers';
import { type Drawn, draw, drawLegend } from '../drawing/plot';
import { look, type Theme } from '../drawing/theme';
import { type Word, say } from '../drawing/words';
import { currentMarks, pointMarks } from './curve_picture';
import { barOf } from './model_picture';
import { createPicker } from './picker';

/** What is drawn of a point, with its error. */
const CURVES: { label: Word; of: (point: AnglePoint) => [value: number, error: number] }[] = [
  { label: 'angle.tangential', of: (point) => [point.tangential, point.tangentialError] },
  { label: 'angle.normal', of: (point) => [point.restitution, point.error] },
];

const UNKNOWN = 0.5; // the error of ε_t where hardly anything slides

function inWords(point: AnglePoint): string {
  const [tangential, normal] = CURVES.map(({ of }) => withError(...of(point)));
  return say('angle.point', { angle: written(point.angle, 3), tangential: tangential!, normal: normal! });
}

/** Makes an empty chart in an element; `pick` gets an angle that a reader has picked. */
export function createAngleChart(host: HTMLElement, pick: (angle: number) => void) {
  let points: readonly AnglePoint[] = [];
  let current: AnglePoint | undefined;
  const axis = () => {
    const both = [...points, ...(current ? [current] : [])].some(({ angle }) => angle < 0);
    return { low: both ? -90 : 0, high: 90, log: false, at: current?.angle, step: 1 };
  };
  const { update, picture } = createPicker(host, {
    title: say('angle.picture'),
    label: say('angle.pick'),
    words: () => (current ? inWords(current) : ''),
    draw: drawAngles,
    axis,
    rounded: (angle) => Math.min(89, Math.max(-89, Math.round(angle))),
    note(pointed) {
      const near = pointed === undefined ? current : least(points, ({ angle }) => Math.abs(angle - pointed));
      return near && inWords(near);
    },
  }, pick);

  function drawAngles(width: number, theme: Theme): Drawn[] {
    const y = { low: -1.05, high: 1.05, log: false };
    const marks = CURVES.flatMap(({ of }, n) => {
      const places = points.filter((point) => of(point)[1] < UNKNOWN).map((point) =>
        ({ ...barOf('restitution', ...of(point)), at: point.angle, converged: point.converged }));
      return pointMarks(places, y, look(n, theme), theme);
    });
    const here = current && currentMarks(current.angle,
      CURVES.map(({ of }) => barOf('restitution', ...of(current!))), y, theme);
    const chart = draw({
      width, height: Math.min(340, Math.max(220, 0.5 * width)),
      x: { ...axis(), label: say('angle.axis') }, y: { ...y, label: say('angle.ordinate') },
      marks: [Plot.ruleY([0], { stroke: theme.muted }), ...marks, ...(here ?? [])],
    }, theme);
    return [chart, drawLegend(CURVES.map(({ label }, n) => ({ label: say(label), ...look(n, theme) })), width, theme)];
  }

  return {
    /** Shows points in any order. */
    setPoints(next: readonly AnglePoint[]): void {
      points = next;
      update();
    },
    /** Shows the point that the inputs stand for. */
    setCurrent(next: AnglePoint): void {
      current = next;
      update();
    },
    picture,
  };
}
