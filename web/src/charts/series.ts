// What the charts of one collision in time show; and in words, for those who do not see them.

import { extent, maxIndex, minIndex, range } from 'd3-array';
import type { Collision, Course, ObliqueCollision } from '../core/protocol';
import { Plot } from '../drawing/library';
import { interpolate, withUnit, written } from '../drawing/numbers';
import { type Axis, type Drawn, draw, unitAlong } from '../drawing/plot';
import { look, type Theme } from '../drawing/theme';
import { type Word, say } from '../drawing/words';

export interface Series {
  label: string;
  values: Float64Array;
}

/** A chart of some series, with its axis. */
export interface Panel extends Axis {
  unit: string;
  series: Series[];
}

const PAD = 0.06;
const NOTHING = 1e-12; // a share of the energy that is not drawn

function panel(label: string, unit: string, series: Series[]): Panel {
  const [low, high] = extent([0, ...series.flatMap(({ values }) => extent(values))] as number[]) as [number, number];
  const span = high > low ? high - low : 1;
  return { label, unit, series, log: false, low: low < 0 ? low - PAD * span : 0, high: low + (1 + PAD) * span };
}

const seriesOf = <Its extends object>(its: Its, labels: { [Name in keyof Its]?: Word }): Series[] =>
  (Object.entries(labels) as [keyof Its, Word][]).map(([name, label]) =>
    ({ label: say(label), values: its[name] as Float64Array }));

/** Force, velocity and energies. Of the energies those that are never there are left out. */
export function panelsOf(collision: Collision | ObliqueCollision): Panel[] {
  const [forces, velocities, energies] = 'across' in collision ? [
    seriesOf(collision, { force: 'time.normal', friction: 'time.friction' }),
    seriesOf(collision, { velocity: 'time.normal', tangential: 'time.surface' }),
    seriesOf(collision, {
      translation: 'time.along_normal', across: 'time.along_surface', rotation: 'time.rotation',
      second_rotation: 'time.second_rotation', elastic: 'time.elastic', friction_loss: 'time.friction_loss',
    }),
  ] as const : [
    seriesOf(collision, { force: 'time.force_line' }), seriesOf(collision, { velocity: 'time.velocity_line' }),
    seriesOf(collision, {
      translation: 'time.translation', vibration: 'time.vibration', stored: 'time.stored', dissipated: 'time.dissipated',
      yielded: 'time.yielded', unresolved: 'time.unresolved',
    }),
  ] as const;
  const { units } = collision;
  return [
    panel(say('time.force'), units.force, forces), panel(say('time.velocity'), units.velocity, velocities),
    panel(say('time.energy'), '',
      energies.filter(({ values }, n) => n === 0 || values.some((each) => Math.abs(each) > NOTHING))),
  ];
}

/** Draws a panel. `lowest`: it has the axis of time. `named`: its name stands above it. */
export function drawPanel(
  { time, units }: Course, panel: Panel, width: number, height: number, lowest: boolean, named: boolean,
  theme: Theme,
): Drawn {
  return draw({
    width, height, bottom: lowest, top: named, y: panel,
    x: { low: time[0] ?? 0, high: time.at(-1) ?? 1, log: false, label: say('time.axis'), unit: units.time },
    marks: panel.series.map(({ values }, k) => {
      const { color, dash } = look(k, theme);
      const thin = thinned(time, values, width);
      const style = { stroke: color, strokeWidth: 1.8, strokeDasharray: dash.join(' '), clip: true };
      return Plot.line(thin.x, { x: thin.x, y: thin.y, ...style });
    }),
  }, theme);
}

/** A curve with at most two points for each of `columns` pieces of it, its least and its greatest. */
export function thinned(x: ArrayLike<number>, y: ArrayLike<number>, columns: number): { x: number[]; y: number[] } {
  const piece = Math.max(1, Math.ceil(x.length / columns));
  const kept = piece <= 2 ? range(x.length) : [0, ...range(0, x.length, piece).flatMap((begin) => {
    const its = range(begin, Math.min(begin + piece, x.length));
    const ends = [minIndex(its, (k) => y[k]!), maxIndex(its, (k) => y[k]!)].map((k) => begin + k);
    return ends.sort((a, b) => a - b);
  }), x.length - 1];
  return { x: kept.map((k) => x[k]!), y: kept.map((k) => y[k]!) };
}

const SMALL = 1e-9; // of what a panel spans

/** The value of one series at a time. */
export function valueWords(collision: Course, panel: Panel, series: Series, time: number): string {
  const value = interpolate(collision.time, series.values, time);
  return written(Math.abs(value) < SMALL * (panel.high - panel.low) ? 0 : value / unitAlong(panel).size, 3);
}

/** What the charts show at one time. */
export function cursorWords(collision: Course, panels: Panel[], time: number): string {
  const values = panels.flatMap((panel) => panel.series.map((each) =>
    `${each.label} ${valueWords(collision, panel, each, time)} ${unitAlong(panel).unit}`.trimEnd()));
  return say('time.cursor', { time: withUnit(time, collision.units.time), values: values.join(', ') });
}

/** What the charts show as a whole. */
export function summaryOf(collision: Collision | ObliqueCollision): string {
  const { force, time, units, velocity } = collision;
  const most = maxIndex(force);
  const energy = (name: string, values: Float64Array): string => `${written(100 * values.at(-1)!, 3)} % ${name}`;
  const shares = 'across' in collision
    ? panelsOf(collision).at(-1)!.series.map(({ label, values }) => energy(label, values))
    : [energy(say('time.translation'), collision.translation), energy(say('time.vibration'), collision.vibration),
      ...(collision.dissipated.at(-1)! > 0 ? [energy(say('time.dissipated'), collision.dissipated)] : []),
      ...(collision.yielded.at(-1)! > 0 ? [energy(say('time.yielded'), collision.yielded)] : [])];
  return say('time.summary', {
    force: withUnit(force[most]!, units.force), time: withUnit(time[most]!, units.time), shares: shares.join(', '),
    end: withUnit(collision.end, units.time), before: withUnit(velocity[0]!, units.velocity),
    after: withUnit(velocity.at(-1)!, units.velocity),
  });
}
