// What the charts of one collision in time show; and in words, for those who do not see them.

import * as Plot from '@observablehq/plot';
import { extent, max, maxIndex, minIndex, range } from 'd3-array';
import type { Collision } from '../core/protocol';
import { prefixFor, unitInWords, withUnit, written } from '../drawing/numbers';
import { type Drawn, draw } from '../drawing/plot';
import { interpolate } from '../drawing/samples';
import { look, type Theme } from '../drawing/theme';

export interface Series {
  label: string;
  values: Float64Array;
}

export interface Panel {
  name: string;
  /** '' for shares */
  unit: string;
  series: Series[];
  low: number;
  high: number;
}

const PAD = 0.06;
const NOTHING = 1e-12; // a share of the energy that is not drawn

function panel(name: string, unit: string, series: Series[]): Panel {
  const [low, high] = extent([0, ...series.flatMap(({ values }) => extent(values))] as number[]) as [number, number];
  const span = high > low ? high - low : 1;
  return { name, unit, series, low: low < 0 ? low - PAD * span : 0, high: low + (1 + PAD) * span };
}

/** Force, velocity and energies. Of the energies those that are never there are left out. */
export function panelsOf(collision: Collision): Panel[] {
  const { units } = collision;
  const energies: Series[] = [
    { label: 'translation', values: collision.translation },
    { label: 'vibration', values: collision.vibration },
    { label: 'stored at the contact', values: collision.stored },
    { label: 'dissipated', values: collision.dissipated },
    { label: 'elastic energy of the contact', values: collision.unresolved },
  ];
  return [
    panel('Force', units.force, [{ label: 'force', values: collision.force }]),
    panel('Velocity', units.speed, [{ label: 'velocity', values: collision.velocity }]),
    panel('Share of the energy', '',
      energies.filter(({ values }, n) => n === 0 || values.some((each) => Math.abs(each) > NOTHING))),
  ];
}

/** The name of a panel with its unit, for its axis. */
export function panelLabel({ name, unit }: Panel): string {
  return unit ? `${name} (${unitInWords(unit)})` : name;
}

/** Draws a panel. `lowest`: it has the axis of time. `named`: its name stands above it. */
export function drawPanel(
  { time, units }: Collision, panel: Panel, width: number, height: number, lowest: boolean, named: boolean,
  theme: Theme,
): Drawn {
  const { low, high, series } = panel;
  const label = `time since first contact (${unitInWords(units.time)})`;
  return draw({
    width, height, bottom: lowest, top: named,
    x: { low: time[0] ?? 0, high: time.at(-1) ?? 1, log: false, label },
    y: { low, high, log: false, label: panelLabel(panel) },
    marks: series.map(({ values }, k) => {
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
export function valueWords(collision: Collision, panel: Panel, series: Series, time: number): string {
  const value = interpolate(collision.time, series.values, time);
  return written(Math.abs(value) < SMALL * (panel.high - panel.low) ? 0 : value, 3);
}

/** What the charts show at one time. */
export function cursorWords(collision: Collision, panels: Panel[], time: number): string {
  const values = panels.flatMap((panel) => panel.series.map((each) =>
    `${each.label} ${valueWords(collision, panel, each, time)} ${unitInWords(panel.unit)}`.trimEnd()));
  return `time ${withUnit(time, collision.units.time)}: ${values.join(', ')}`;
}

/** What the charts show as a whole. */
export function summaryOf(collision: Collision): string {
  const { force, time, units, velocity, translation, vibration, dissipated } = collision;
  const most = maxIndex(force);
  const energy = (name: string, values: Float64Array): string => `${written(100 * values.at(-1)!, 3)} % ${name}`;
  return `The force is at its maximum, ${withUnit(force[most]!, units.force)}, ` +
    `${withUnit(time[most]!, units.time)} after first contact; the last contact is after ` +
    `${withUnit(collision.end, units.time)}. The velocity goes from ${withUnit(velocity[0]!, units.speed)} to ` +
    `${withUnit(velocity.at(-1)!, units.speed)}. At the end the energy is ${energy('translation', translation)}, ` +
    `${energy('vibration', vibration)}${dissipated.at(-1)! > 0 ? `, ${energy('dissipated', dissipated)}` : ''}.`;
}

/** The same collision with prefixes of SI that suit its times and forces; `second`: its unit of time in the old one. */
export function readable(collision: Collision): { collision: Collision; second: number } {
  const { time, force, units, begin, end } = collision;
  const prefix = (values: Float64Array, unit: string): ReturnType<typeof prefixFor> =>
    prefixFor(max(values, Math.abs) ?? 0, unit);
  const [seconds, newtons] = [prefix(time, units.time), prefix(force, units.force)];
  return {
    second: seconds.size,
    collision: {
      ...collision,
      units: { ...units, time: seconds.unit, force: newtons.unit },
      time: time.map((each) => each / seconds.size),
      force: force.map((each) => each / newtons.size),
      begin: begin / seconds.size,
      end: end / seconds.size,
    },
  };
}
