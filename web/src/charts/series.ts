// What the charts of one collision in time show.

import * as Plot from '@observablehq/plot';
import type { Collision } from '../core/protocol';
import { unitInWords } from '../drawing/numbers';
import { type Drawn, draw } from '../drawing/plot';
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
  let [low, high] = [0, 0];
  for (const { values } of series) {
    for (const each of values) {
      low = Math.min(low, each);
      high = Math.max(high, each);
    }
  }
  if (!(high > low)) high = low + 1;
  const pad = PAD * (high - low);
  return { name, unit, series, low: low < 0 ? low - pad : 0, high: high + pad };
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
    x: { low: time[0] ?? 0, high: time[time.length - 1] ?? 1, log: false, label },
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
  const thin = { x: [] as number[], y: [] as number[] };
  const add = (k: number): void => {
    thin.x.push(x[k]!);
    thin.y.push(y[k]!);
  };
  const piece = Math.max(1, Math.ceil(x.length / columns));
  if (piece <= 2) return { x: Array.from(x), y: Array.from(y) };
  add(0);
  for (let begin = 0; begin < x.length; begin += piece) {
    let [least, most] = [begin, begin];
    for (let k = begin; k < Math.min(begin + piece, x.length); ++k) {
      if (y[k]! < y[least]!) least = k;
      if (y[k]! > y[most]!) most = k;
    }
    for (const k of least < most ? [least, most] : most < least ? [most, least] : [least]) add(k);
  }
  add(x.length - 1);
  return thin;
}
