// What the charts of one collision in time show; and in words, for those who do not see them.

import * as Plot from '@observablehq/plot';
import { extent, maxIndex, minIndex, range } from 'd3-array';
import type { Collision, Course, ObliqueCollision } from '../core/protocol';
import { interpolate, withUnit, written } from '../drawing/numbers';
import { type Axis, type Drawn, draw, unitAlong } from '../drawing/plot';
import { look, type Theme } from '../drawing/theme';

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

const seriesOf = <Its extends object>(its: Its, labels: { [Name in keyof Its]?: string }): Series[] =>
  (Object.entries(labels) as [keyof Its, string][]).map(([name, label]) => ({ label, values: its[name] as Float64Array }));

/** Force, velocity and energies. Of the energies those that are never there are left out. */
export function panelsOf(collision: Collision | ObliqueCollision): Panel[] {
  const [forces, velocities, energies] = 'across' in collision ? [
    seriesOf(collision, { force: 'along the normal', friction: 'friction' }),
    seriesOf(collision, { velocity: 'along the normal', tangential: 'along the surface' }),
    seriesOf(collision, {
      translation: 'motion along the normal', across: 'motion along the surface', rotation: 'rotation',
      second_rotation: 'rotation of what it meets', elastic: 'in the elastic bodies', friction_loss: 'heat of friction',
    }),
  ] as const : [
    seriesOf(collision, { force: 'force' }), seriesOf(collision, { velocity: 'velocity' }),
    seriesOf(collision, {
      translation: 'translation', vibration: 'vibration', stored: 'stored at the contact', dissipated: 'dissipated',
      unresolved: 'elastic energy of the contact',
    }),
  ] as const;
  const { units } = collision;
  return [
    panel('Force', units.force, forces), panel('Velocity', units.velocity, velocities),
    panel('Share of the energy', '',
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
    x: { low: time[0] ?? 0, high: time.at(-1) ?? 1, log: false, label: 'time since first contact', unit: units.time },
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
  return `time ${withUnit(time, collision.units.time)}: ${values.join(', ')}`;
}

/** What the charts show as a whole. */
export function summaryOf(collision: Collision | ObliqueCollision): string {
  const { force, time, units, velocity } = collision;
  const most = maxIndex(force);
  const energy = (name: string, values: Float64Array): string => `${written(100 * values.at(-1)!, 3)} % ${name}`;
  const shares = 'across' in collision
    ? panelsOf(collision).at(-1)!.series.map(({ label, values }) => energy(label, values))
    : [energy('translation', collision.translation), energy('vibration', collision.vibration),
      ...(collision.dissipated.at(-1)! > 0 ? [energy('dissipated', collision.dissipated)] : [])];
  return `The force is at its maximum, ${withUnit(force[most]!, units.force)}, ` +
    `${withUnit(time[most]!, units.time)} after first contact; the last contact is after ` +
    `${withUnit(collision.end, units.time)}. The velocity goes from ${withUnit(velocity[0]!, units.velocity)} to ` +
    `${withUnit(velocity.at(-1)!, units.velocity)}. At the end the energy is ${shares.join(', ')}.`;
}
